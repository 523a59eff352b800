// Other threads look at a controller that runs, and ask it for changes.
#include <doctest/doctest.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include <cca/config.hpp>
#include <cca/runtime/live/live_access.hpp>

#include "live_rig.hpp"

using namespace live_test;

namespace {

struct watched_graph : cca::graph<cca::rate<1000>,
                                  cca::node<"source", source, cca::stoppable<cca::timed<1>>>,
                                  cca::node<"other", source>,
                                  cca::observe<"source.y">> {};
using played = cca::controller<watched_graph>;

}  // namespace

TEST_SUITE("live access") {
  TEST_CASE("another thread sees whole samples, and the newest") {
    auto c = started<played>();
    cca::live_access live(c);
    CHECK_FALSE(live.newest("source.y"));
    beside(c, live, cca::at_speed(5), [&] {
      wait_until([&] { return live.newest("source.y").has_value(); });
      std::int64_t last = -1;
      for (int i = 0; i < 2000; ++i) {
        const auto seen = live.newest("source.y");
        if (!seen) continue;
        CHECK_EQ(seen->values.size(), 2);
        CHECK_EQ(seen->values[0], seen->values[1]);
        CHECK_GE(seen->origin, last);
        last = seen->origin;
      }
      wait_until([&] { return live.beat_index() > 10; });
      CHECK_EQ(live.state(), cca::state::running);
    });
    CHECK_EQ(live.newest("source.y")->values[0], c.get<"source">().value);
    CHECK_EQ(refusal([&] { (void)live.newest("other.y"); }),
             "cca::live_access: nobody observes `other.y`: add cca::observe<\"other.y\"> to the items of the "
             "graph");
    CHECK_EQ(refusal([&] { (void)live.newest("sorce.y"); }),
             "cca::live_access: newest: there is no output `sorce.y`; did you mean `source.y`?");
    CHECK_EQ(refusal([&] { (void)live.newest("a.port.far.away"); }),
             "cca::live_access: newest: there is no output `a.port.far.away`: give the path of one, as in "
             "`robot.angles`");
  }

  TEST_CASE("requests of another thread are taken between two beats") {
    auto c = started<played>();
    cca::live_access live(c);
    beside(c, live, cca::at_speed(5), [&] {
      wait_until([&] { return live.set("source.slope", 2.0); });
      wait_until([&] { return live.is_taken(); });
      wait_until([&] { return live.set<"other">({3.0, false, 3.0}); });
      wait_until([&] { return live.stop("source"); });
      wait_until([&] { return live.is_taken(); });
      const auto first = newest_in(live, "source.y");
      const auto beat = live.beat_index();
      wait_until([&] { return live.beat_index() > beat + 10; });
      CHECK_EQ(live.newest("source.y")->values[0], first);
      wait_until([&] { return live.start("source"); });
      wait_until([&] { return live.newest("source.y")->values[0] > first; });
      CHECK_EQ(live.parameter("source.slope").value_or("busy"), "2.0");
    });
    CHECK_EQ(c.get<"source">().p.slope, 2.0);
    CHECK_EQ(c.get<"other">().p.slope, 3.0);
  }

  TEST_CASE("a run pauses, makes single beats, and goes on without catching up") {
    struct idling {
      auto sense() -> cca::out<"y", pair> { return Eigen::Vector2d(0, 0); }
      void on_idle() { ++idles; }
      int idles = 0;
    };
    struct with_robot
        : cca::graph<cca::rate<1000>, cca::node<"robot", idling>,
                     cca::node<"source", source, cca::stoppable<cca::timed<1>>>, cca::observe<"source.y">> {};
    auto c = started<cca::controller<with_robot>>();
    cca::live_access live(c);
    std::int64_t paused_at = 0, stepped_to = 0;
    beside(c, live, cca::at_wall_clock(), [&] {
      wait_until([&] { return live.beat_index() > 10; });
      CHECK_FALSE(live.is_paused());
      live.pause();
      wait_until([&] { return live.is_paused(); });
      std::this_thread::sleep_for(30ms);
      paused_at = live.beat_index();
      std::this_thread::sleep_for(60ms);
      CHECK_EQ(live.beat_index(), paused_at);
      CHECK_EQ(live.state(), cca::state::running);
      live.step();
      wait_until([&] { return live.beat_index() == paused_at + 1; });
      live.step();
      live.step();
      wait_until([&] { return live.beat_index() == paused_at + 3; });
      std::this_thread::sleep_for(30ms);
      stepped_to = live.beat_index();
      wait_until([&] { return live.stop("source"); });  // requests are taken in a pause
      wait_until([&] { return live.is_taken(); });
      live.go_on();
      wait_until([&] { return live.beat_index() > stepped_to + 20; });
      CHECK_FALSE(live.is_paused());
    });
    CHECK_EQ(stepped_to, paused_at + 3);
    CHECK_EQ(c.get<"source">().value, static_cast<double>(stepped_to));
    CHECK_GT(c.get<"robot">().idles, 30);
    CHECK_LT(c.lost_periods(), 60);  // not those of the pause
  }

  TEST_CASE("the speed of a run changes") {
    auto c = started<played>();
    cca::live_access live(c);
    beside(c, live, cca::at_speed(0.05), [&] {
      wait_until([&] { return live.beat_index() > 1; });
      live.set_speed(50);
      wait_until([&] { return live.beat_index() > 5000; });  // 100 s before
      CHECK_FALSE(live.has_refused_speed());
      CHECK_EQ(refusal([&] { live.set_speed(0); }),
               "cca::live_access: set_speed: 0.000000 is no speed, expected a number above 0");
    });
    cca::live_access other(c);
    beside(c, other, cca::as_fast_as_possible(), [&] {
      other.set_speed(2);
      wait_until([&] { return other.has_refused_speed(); });
    });
  }

  TEST_CASE("a run whose beats are minutes apart gets another speed, pauses and ends at once") {
    auto c = started<played>();
    cca::live_access live(c);
    const auto begun = std::chrono::steady_clock::now();
    beside(c, live, cca::at_speed(1e-5), [&] {
      wait_until([&] { return live.beat_index() == 1; });
      live.set_speed(1);
      wait_until([&] { return live.beat_index() > 10; });
      live.set_speed(1e-5);
      wait_until([&] { return live.set("source.slope", 2.0); });  // requests are taken meanwhile
      wait_until([&] { return live.is_taken(); });
      live.pause();
      wait_until([&] { return live.is_paused(); });
      live.go_on();
      wait_until([&] { return !live.is_paused(); });
    });
    CHECK(std::chrono::steady_clock::now() - begun < 50s);  // a beat takes 100 s
    CHECK_EQ(c.get<"source">().p.slope, 2.0);
  }

  TEST_CASE("after a run the window sees how it ended, and no pause of it") {
    auto c = started<played>();
    cca::live_access live(c);
    live.pause();
    for (int i = 0; i < 3; ++i) live.step();
    c.run(cca::for_beats<3>{}, cca::as_fast_as_possible{}, live);  // it ends by its length, in a pause
    CHECK_EQ(live.beat_index(), 3);
    CHECK_EQ(live.state(), cca::state::started);
    CHECK_FALSE(live.is_paused());
  }

  TEST_CASE("parameters are saved and loaded while it runs, also of one component") {
    auto c = started<played>();
    cca::live_access live(c);
    const std::string file = "cca_live_saved.toml";
    beside(c, live, cca::at_speed(5), [&] {
      wait_until([&] { return live.set("source.slope", 2.0); });
      wait_until([&] { return live.set("source.same", 2.0); });
      wait_until([&] { return live.save(file, "source"); });
      wait_until([&] { return live.set("source.slope", 3.0); });
      wait_until([&] { return live.load(file, "source"); });
      wait_until([&] { return live.is_taken(); });
      CHECK_EQ(live.parameter("source.slope").value_or("busy"), "2.0");
    });
    CHECK_EQ(c.get<"source">().p.slope, 2.0);
    std::ifstream saved(file);
    const std::string text{std::istreambuf_iterator<char>(saved), {}};
    CHECK(text.starts_with("[source]\nslope = 2.0  # 0 to 100; was 1.0\n"));
    CHECK_EQ(text.find("[other]"), std::string::npos);
    std::remove(file.c_str());
  }

  TEST_CASE("a window in another thread") {
    const auto show = [](double) {};
    // [live]
    cca::controller<watched_graph> c;
    c.load();
    c.start();
    cca::live_access live(c);
    std::thread window([&] {
      while (!live.set("source.slope", 2.0)) {}  // taken between two beats
      if (const auto seen = live.newest("source.y")) show(seen->values[0]);
      live.end_run();
    });
    c.run(cca::for_<10>{}, cca::at_wall_clock(), live);
    window.join();
    // [live end]
    CHECK(c.beat_index() < 10'000);
  }

  TEST_CASE("an output that an inner graph exposes has that name, too") {
    struct body : cca::graph<cca::node<"legs", source>, cca::expose<"legs.y", "angles">> {};
    struct with_body : cca::graph<cca::rate<1000>, cca::node<"robot", body>, cca::node<"other", source>,
                                  cca::observe<"other.y">> {};
    auto c = started<cca::controller<with_body>>();
    cca::live_access live(c);
    CHECK_EQ(refusal([&] { (void)live.newest("robot.angles"); }),
             "cca::live_access: nobody observes `robot.angles`: add cca::observe<\"robot.angles\"> to the "
             "items of the graph");
    CHECK_EQ(refusal([&] { (void)live.newest("robot.anlges"); }),
             "cca::live_access: newest: there is no output `robot.anlges`; did you mean `robot.angles`?");
  }

  TEST_CASE("a run of no beats takes the request that waits, and so does the end of a run") {
    auto c = started<played>();
    cca::live_access live(c);
    CHECK(live.set("source.slope", 5.0));
    CHECK_FALSE(live.is_taken());
    c.run(cca::for_beats<0>{}, cca::as_fast_as_possible{}, live);
    CHECK(live.is_taken());
    CHECK_EQ(c.get<"source">().p.slope, 5.0);
    CHECK_EQ(c.beat_index(), 0);
    CHECK(live.stop("source"));
    c.run(cca::for_beats<0>{}, cca::at_wall_clock(), live);
    CHECK(c.is_stopped("source"));
    CHECK_EQ(c.get<"source">().stops, 1);
  }

  TEST_CASE("what is wrong is refused in the thread that asks, and nothing changes") {
    auto c = started<played>();
    cca::live_access live(c);
    CHECK_EQ(refusal([&] { live.set("source.slope", 200.0); }),
             "cca::controller: set: source.slope: 200 is out of range, expected 0 to 100");
    CHECK_EQ(refusal([&] { live.set<"source">({-1.0, false, 1.0}); }),
             "source.slope: -1 is out of range, expected 0 to 100");
    CHECK_EQ(refusal([&] { live.stop("other"); }),
             "cca::controller: `other` can't be stopped on its own: write cca::stoppable<...> around the "
             "strategy of its node");
    CHECK_EQ(refusal([&] { live.load("nothing.toml", "sauce"); }),
             "cca::controller: load: there is no node `sauce`");
    CHECK_EQ(refusal([&] { live.save("nothing.toml", "sauce"); }),
             "cca::controller: save: there is no node `sauce`");
    CHECK(live.is_taken());
    CHECK(live.set("source.slope", 5.0));
    CHECK_FALSE(live.set("source.slope", 6.0));  // the first has not been taken
    CHECK_FALSE(live.parameter("source.slope"));
    c.run(cca::for_beats<1>{}, cca::as_fast_as_possible{}, live);
    CHECK_EQ(c.get<"source">().p.slope, 5.0);
  }

  TEST_CASE("a component may refuse when the request is taken") {
    auto c = started<played>();
    cca::live_access live(c);
    CHECK(live.set<"source">({7.0, true, 7.0}));
    c.run(cca::for_beats<1>{}, cca::as_fast_as_possible{}, live);
    CHECK_EQ(live.refused_by(), "");
    CHECK(live.set("source.slope", 8.0));
    c.run(cca::for_beats<1>{}, cca::as_fast_as_possible{}, live);
    CHECK_EQ(live.refused_by(), "source");
    CHECK_EQ(c.get<"source">().p.slope, 7.0);
    CHECK_EQ(live.parameter("source.slope").value_or("busy"), "7.0");
  }

  TEST_CASE("a file is loaded while the controller runs, from its own thread and from another one") {
    const std::string file = "live_access.toml";
    std::ofstream(file) << "[source]\nslope = 4\n[other]\nslope = 9\n";
    auto c = started<played>();
    c.load(file);
    CHECK_EQ(c.state(), cca::state::started);
    CHECK_EQ(c.get<"other">().p.slope, 9.0);
    std::ofstream(file) << "[source]\nslope = 400\n[other]\nslope = 1\n";
    CHECK_EQ(refusal([&] { c.load(file); }),
             file + ":2: source.slope: 400 is out of range, expected 0 to 100");
    CHECK_EQ(c.get<"other">().p.slope, 9.0);

    c.set<"source">({4.0, true, 4.0});
    std::ofstream(file) << "[source]\nslope = 5\n[other]\nslope = 1\n";
    CHECK_EQ(refusal([&] { c.load(file); }), file + ": source.slope: it is locked");
    CHECK_EQ(c.get<"other">().p.slope, 9.0);

    c.set<"source">({4.0, false, 4.0});
    cca::live_access live(c);
    beside(c, live, cca::at_speed(5), [&] {
      wait_until([&] { return live.load(file); });
      wait_until([&] { return live.is_taken(); });
    });
    CHECK_EQ(c.get<"source">().p.slope, 5.0);
    CHECK_EQ(c.get<"other">().p.slope, 1.0);
    std::remove(file.c_str());
  }
}
