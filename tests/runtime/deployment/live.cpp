// Other threads look at a deployment that runs, and ask its environments for changes.
#include <doctest/doctest.h>

#include <unistd.h>

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>
#include <string_view>
#include <thread>
#include <type_traits>
#include <vector>

#include <cca/config.hpp>
#include <cca/deployment.hpp>
#include <cca/runtime/live/live_access.hpp>

#include "../core/live_rig.hpp"

using namespace live_test;

namespace {

struct follower : source {
  auto process(cca::in<"x", pair> x, cca::beat now) -> cca::out<"y", pair> {
    last = x[cca::x{}];
    return source::process(now);
  }
  double last = 0;
};

struct watched_graph : cca::graph<cca::rate<1000>,
                                  cca::node<"robot", source, cca::stoppable<cca::timed<1>>>,
                                  cca::node<"thinker", follower, cca::stoppable<cca::timed<2>>>,
                                  cca::node<"planner", follower, cca::timed<5>>,
                                  cca::node<"asleep", source, cca::inactive>,
                                  cca::wire<"robot.y", "thinker.x", cca::delayed<2>>,
                                  cca::wire<"thinker.y", "planner.x", cca::delayed<5>>,
                                  cca::observe<"planner.y">,
                                  cca::observe<"robot.y">,
                                  cca::observe<"thinker.y">> {};
// `robot` first and last among the nodes, so that paths and environments are in different orders.
struct split : cca::deployment<watched_graph,
                               cca::environment<"body", cca::nodes<"robot">>,
                               cca::environment<"plans", cca::nodes<"planner">>,
                               cca::environment<"mind", cca::nodes<"thinker">>,
                               cca::environment<"rest", cca::other_nodes>,
                               cca::tolerate<1000000>> {};
using played = cca::deployed<split>;

struct seldom : cca::deployment<cca::graph<cca::rate<1000>,
                                           cca::node<"robot", source, cca::timed<1>>,
                                           cca::node<"planner", source, cca::stoppable<cca::timed<60000>>>>,
                                cca::environment<"body", cca::nodes<"robot">>,
                                cca::environment<"plans", cca::other_nodes>> {};

struct guard {
  auto process(cca::beat now) -> cca::fault {
    return now.index() == 4 ? cca::fault("it is asked to fault") : cca::fault();
  }
};
struct guarded
    : cca::deployment<cca::graph<cca::rate<1000>, cca::node<"robot", guard>, cca::node<"thinker", source>>,
                      cca::environment<"body", cca::nodes<"robot">>,
                      cca::environment<"mind", cca::other_nodes>> {};

struct started_one : played {
  started_one() {
    load();
    start();
  }
};

void both_paces(auto test) {
  SUBCASE("in a fast run") { test(cca::as_fast_as_possible{}); }
  SUBCASE("in a wall-clock run") { test(cca::at_speed(5)); }
}

}  // namespace

TEST_SUITE("live access to a deployment") {
  TEST_CASE("all environments pause, make single beats, and go on") {
    both_paces([](auto pace) {
      started_one c;
      played& d = c;
      cca::live_access<played> live(d);
      beside(d, live, pace, [&] {
        wait_until([&] { return live.beat_index() > 20; });
        live.pause();
        wait_until([&] { return live.is_paused(); });
        std::this_thread::sleep_for(30ms);  // the followers end their beats
        const auto at = live.beat_index();
        const double planned = newest_in(live, "planner.y"), thought = newest_in(live, "thinker.y");
        std::this_thread::sleep_for(60ms);
        CHECK_EQ(live.beat_index(), at);
        CHECK_EQ(newest_in(live, "planner.y"), planned);
        CHECK_EQ(newest_in(live, "thinker.y"), thought);
        for (int i = 1; i <= 10; ++i) {
          live.step();
          wait_until([&] { return live.beat_index() == at + i; });
        }
        // On a busy machine one that follows a clock may leave out a beat.
        const int most_lost = std::is_same_v<decltype(pace), cca::as_fast_as_possible> ? 0 : 1;
        const auto has_made = [&](const char* path, double from, int firings) {
          const double made = newest_in(live, path) - from;
          return made <= firings && made >= firings - most_lost;
        };
        wait_until([&] { return has_made("thinker.y", thought, 5); });
        wait_until([&] { return has_made("planner.y", planned, 2); });
        CHECK_EQ(live.beat_index(), at + 10);
        live.go_on();
        wait_until([&] { return live.beat_index() > at + 100; });
      });
      CHECK(!d.fault());
    });
  }

  TEST_CASE("in a pause each environment takes its share of a request, without a beat") {
    both_paces([](auto pace) {
      started_one c;
      played& d = c;
      cca::live_access<played> live(d);
      beside(d, live, pace, [&] {
        wait_until([&] { return live.beat_index() > 20; });
        live.pause();
        wait_until([&] { return live.is_paused(); });
        const auto at = live.beat_index();
        for (const char* path : {"thinker.slope", "planner.slope", "robot.slope"})
          insist(live, [&] { return live.set(path, 4.0); });
        CHECK_EQ(live.beat_index(), at);
        CHECK(live.is_paused());
      });
      CHECK_EQ(d.get<"thinker">().p.slope, 4.0);
      CHECK_EQ(d.get<"planner">().p.slope, 4.0);
      CHECK_EQ(d.get<"robot">().p.slope, 4.0);
      CHECK(!d.fault());
    });
  }

  TEST_CASE("the speed of all environments changes") {
    started_one c;
    played& d = c;
    cca::live_access<played> live(d);
    beside(d, live, cca::at_speed(0.05), [&] {
      wait_until([&] { return live.beat_index() > 1; });
      live.set_speed(20);
      wait_until([&] { return live.beat_index() > 2000; });
      wait_until([&] { return newest_in(live, "planner.y") > 300; });
    });
    CHECK(!d.fault());
  }

  TEST_CASE("a run whose beats are minutes apart gets another speed and ends at once") {
    started_one c;
    played& d = c;
    cca::live_access<played> live(d);
    const auto begun = std::chrono::steady_clock::now();
    beside(d, live, cca::at_speed(1e-5), [&] {
      wait_until([&] { return live.beat_index() == 1; });
      live.set_speed(1);
      wait_until([&] { return live.beat_index() > 10; });
      live.set_speed(1e-5);
    });
    CHECK(std::chrono::steady_clock::now() - begun < 50s);  // a beat takes 100 s
  }

  TEST_CASE("after a run the window sees how it ended, a fault too, and no pause of it") {
    both_paces([](auto pace) {
      cca::deployed<guarded> d;
      d.load();
      d.start();
      cca::live_access live(d);
      live.pause();
      for (int i = 0; i < 3; ++i) live.step();
      d.run(cca::for_beats<3>{}, pace, live);  // it ends by its length, in a pause
      CHECK_EQ(live.beat_index(), 3);
      CHECK_EQ(live.state(), cca::state::started);
      CHECK_FALSE(live.is_paused());
      live.go_on();
      d.run(cca::for_beats<3>{}, pace, live);
      CHECK_EQ(live.state(), cca::state::faulted);
      CHECK_EQ(std::string_view(live.fault().reason()), "it is asked to fault");
    });
  }

  TEST_CASE("another thread sees whole samples of each environment, and the newest") {
    both_paces([](auto pace) {
      constexpr bool is_exact = std::is_same_v<decltype(pace), cca::as_fast_as_possible>;
      started_one c;
      played& d = c;
      cca::live_access<played> live(d);
      CHECK_FALSE(live.newest("thinker.y"));
      beside(d, live, pace, [&] {
        for (const char* const path : {"robot.y", "thinker.y", "planner.y"}) {
          wait_until([&] { return live.newest(path).has_value(); });
          std::int64_t last = -1;
          for (int i = 0; i < 2000; ++i) {
            const auto seen = live.newest(path);
            if (!seen) continue;
            CHECK_EQ(seen->values.size(), 2);
            CHECK_EQ(seen->values[0], seen->values[1]);
            // In a wall-clock run an input may be late: before its first sample an output is as old as its
            // beat.
            if (is_exact || path == std::string_view("robot.y")) CHECK_GE(seen->origin, last);
            last = seen->origin;
          }
        }
        const auto beat = live.beat_index();
        wait_until([&] { return live.beat_index() > beat + 10; });
        CHECK_EQ(live.state(), cca::state::running);
      });
      CHECK_EQ(live.newest("robot.y")->values[0], d.get<"robot">().value);
      CHECK_EQ(live.newest("thinker.y")->values[0], d.get<"thinker">().value);
      CHECK_EQ(live.newest("planner.y")->values[0], d.get<"planner">().value);
      CHECK_EQ(live.beat_index(), d.beat_index());
    });
  }

  TEST_CASE("an output that does not exist is refused with the nearest one, of whichever environment") {
    started_one c;
    played& d = c;
    cca::live_access<played> live(d);
    CHECK_EQ(refusal([&] { (void)live.newest("thinker.x"); }),
             "cca::live_access: newest: there is no output `thinker.x`; did you mean `thinker.y`?");
    CHECK_EQ(refusal([&] { (void)live.newest("asleep.y"); }),
             "cca::live_access: nobody observes `asleep.y`: add cca::observe<\"asleep.y\"> to the items of "
             "the graph, and ask the process that runs it");
  }

  TEST_CASE("a run of no beats takes the request that waits, as of a controller") {
    both_paces([](auto pace) {
      started_one c;
      played& d = c;
      cca::live_access<played> live(d);
      CHECK(live.set("thinker.slope", 5.0));
      d.run(cca::for_beats<0>{}, pace, live);
      CHECK(live.is_taken());
      CHECK_EQ(d.get<"thinker">().p.slope, 5.0);
      CHECK_EQ(d.beat_index(), 0);
    });
  }

  TEST_CASE("a window in another thread") {
    const auto show = [](double) {};
    // [live]
    cca::deployed<split> d;
    d.load();
    d.start();
    cca::live_access live(d);
    std::thread window([&] {
      while (!live.set("thinker.slope", 2.0)) {}  // taken by its environment
      if (const auto seen = live.newest("thinker.y")) show(seen->values[0]);
      live.end_run();
    });
    d.run(cca::for_<10>{}, cca::at_wall_clock(), live);
    window.join();
    // [live end]
    CHECK_EQ(d.get<"thinker">().p.slope, 2.0);
    CHECK(d.beat_index() < 10'000);
  }

  TEST_CASE("each environment takes its requests between two of its beats") {
    both_paces([](auto pace) {
      started_one c;
      played& d = c;
      cca::live_access<played> live(d);
      beside(d, live, pace, [&] {
        insist(live, [&] { return live.set("robot.slope", 2.0); });
        insist(live, [&] { return live.set<"thinker">({3.0, false, 3.0}); });
        insist(live, [&] { return live.set("planner.slope", 4.0); });
        CHECK_EQ(live.refused_by(), "");
        CHECK_EQ(live.parameter("thinker.slope").value_or("busy"), "3.0");

        insist(live, [&] { return live.stop("thinker"); });
        wait_until([&] { return live.newest("thinker.y").has_value(); });
        const auto first = newest_in(live, "thinker.y");
        const auto beat = live.beat_index();
        wait_until([&] { return live.beat_index() > beat + 20; });
        CHECK_EQ(newest_in(live, "thinker.y"), first);
        CHECK_GT(newest_in(live, "robot.y"), 0);
        insist(live, [&] { return live.start("thinker"); });
        wait_until([&] { return newest_in(live, "thinker.y") > first; });
      });
      CHECK_EQ(d.get<"robot">().p.slope, 2.0);
      CHECK_EQ(d.get<"thinker">().p.slope, 3.0);
      CHECK_EQ(d.get<"planner">().p.slope, 4.0);
      CHECK_EQ(d.get<"thinker">().stops, 1);
      CHECK_EQ(d.get<"thinker">().starts, 2);
      CHECK_EQ(d.get<"robot">().stops, 0);
    });
  }

  TEST_CASE("a component that is started begins anew, by the beats of its environment") {
    started_one c;
    played& d = c;
    cca::live_access<played> live(d);
    d.run(cca::for_beats<10>{}, cca::as_fast_as_possible{}, live);
    CHECK(live.stop("thinker"));
    d.run(cca::for_beats<10>{}, cca::as_fast_as_possible{}, live);
    const double stopped = d.get<"thinker">().value;
    CHECK(live.start("thinker"));
    d.run(cca::for_beats<10>{}, cca::as_fast_as_possible{}, live);
    CHECK_GE(d.get<"thinker">().value, stopped + 4);
  }

  TEST_CASE("a file: each environment takes its part") {
    const std::string file = "live_deployment.toml";
    std::ofstream(file)
        << "[robot]\nslope = 5\n[thinker]\nslope = 6\n[planner]\nslope = 7\n[asleep]\nslope = 8\n";
    both_paces([&](auto pace) {
      started_one c;
      played& d = c;
      cca::live_access<played> live(d);
      beside(d, live, pace, [&] {
        wait_until([&] { return live.load(file); });
        wait_until([&] { return live.is_taken(); });  // also in `rest`, where nothing fires
        wait_until([&] { return live.state() == cca::state::running; });  // as of the last look
        CHECK_EQ(live.parameter("asleep.slope").value_or("busy"), "8.0");
        live.pause();
        wait_until([&] { return live.is_paused(); });
        insist(live, [&] { return live.set("asleep.slope", 8.5); });
        CHECK(live.is_paused());
        live.go_on();
      });
      CHECK_EQ(d.get<"robot">().p.slope, 5.0);
      CHECK_EQ(d.get<"thinker">().p.slope, 6.0);
      CHECK_EQ(d.get<"planner">().p.slope, 7.0);
      CHECK_EQ(d.get<"asleep">().p.slope, 8.5);
    });
    std::remove(file.c_str());
  }

  TEST_CASE("an environment that fires seldom takes a request long before its next beat") {
    cca::deployed<seldom> d;
    d.load();
    d.start();
    cca::live_access live(d);
    beside(d, live, cca::at_wall_clock(), [&] {
      wait_until([&] { return live.beat_index() > 10; });
      insist(live, [&] { return live.set("planner.slope", 3.0); });
      insist(live, [&] { return live.stop("planner"); });
      insist(live, [&] { return live.start("planner"); });
      CHECK(live.beat_index() < 60'000);
    });
    CHECK_EQ(d.get<"planner">().p.slope, 3.0);
    CHECK_EQ(d.get<"planner">().starts, 2);
    CHECK_LE(d.get<"planner">().value, 3.0);  // it has fired once, in the first beat
  }

  TEST_CASE("what is wrong is refused in the thread that asks - a component may refuse later") {
    started_one c;
    played& d = c;
    cca::live_access<played> live(d);
    CHECK_EQ(refusal([&] { live.set("thinker.slope", 200.0); }),
             "cca::controller: set: thinker.slope: 200 is out of range, expected 0 to 100");
    CHECK_EQ(refusal([&] { live.stop("planner"); }),
             "cca::controller: `planner` can't be stopped on its own: write cca::stoppable<...> around the "
             "strategy of its node");
    CHECK(refusal([&] { live.set("thinkr.slope", 1.0); }).find("did you mean") != std::string::npos);
    CHECK(refusal([&] { (void)live.newest("asleep.y"); }).find("nobody observes `asleep.y`") !=
          std::string::npos);
    CHECK(live.is_taken());

    CHECK(live.set<"thinker">({7.0, true, 7.0}));
    CHECK_FALSE(live.set("robot.slope", 9.0));  // the first has not been taken
    CHECK_FALSE(live.parameter("robot.slope"));
    d.run(cca::for_beats<2>{}, cca::as_fast_as_possible{}, live);
    CHECK_EQ(live.refused_by(), "");
    CHECK(live.set("thinker.slope", 8.0));
    d.run(cca::for_beats<2>{}, cca::as_fast_as_possible{}, live);
    CHECK_EQ(live.refused_by(), "thinker");
    CHECK_EQ(d.get<"thinker">().p.slope, 7.0);
    CHECK_EQ(live.parameter("thinker.slope").value_or("busy"), "7.0");
    CHECK(live.set("robot.slope", 9.0));
    CHECK_EQ(live.refused_by(), "");
  }

  TEST_CASE("one process of several: what runs elsewhere is refused") {
    const std::string name = "/cca_live_" + std::to_string(::getpid());
    played d(cca::only{"body"}, cca::shared_memory(name));
    d.load();
    cca::live_access<played> live(d);
    const std::string elsewhere =
        "cca::deployed: `thinker` runs in environment `mind`, which another process runs";
    CHECK_EQ(refusal([&] { live.set("thinker.slope", 2.0); }), elsewhere);
    CHECK_EQ(refusal([&] { live.set<"thinker">({2.0, false, 2.0}); }), elsewhere);
    CHECK_EQ(refusal([&] { (void)live.parameter("thinker.slope"); }), elsewhere);
    CHECK(refusal([&] { (void)live.newest("thinker.y"); }).find("ask the process that runs it") !=
          std::string::npos);
    CHECK_FALSE(live.newest("robot.y"));
    CHECK(live.is_taken());
    CHECK(live.set("robot.slope", 2.0));
  }

  TEST_CASE("who only looks changes no result") {
    started_one c;
    played& d = c;
    cca::live_access<played> live(d);
    d.run(cca::for_beats<500>{}, cca::as_fast_as_possible{}, live);
    cca::controller<watched_graph> one;
    one.load();
    one.start();
    one.run(cca::for_beats<500>{});
    CHECK_EQ(d.get<"planner">().last, one.get<"planner">().last);
    CHECK_EQ(d.get<"planner">().value, one.get<"planner">().value);
    CHECK_EQ(live.newest("planner.y")->values[0], one.get<"planner">().value);
    one.observed([&](const cca::observation& o) {
      const auto seen = live.newest(o.path);
      REQUIRE(seen);
      CHECK_EQ(seen->values[0], o.values[0]);
      CHECK_EQ(seen->origin, o.origin);
    });
  }

  TEST_CASE("windows in several threads, on busy cores") {
    both_paces([](auto pace) {
      started_one c;
      played& d = c;
      cca::live_access<played> live(d);
      const busy_cores load(2);
      std::atomic<int> torn{0}, taken{0}, running{4};
      std::vector<std::thread> windows;
      for (int w = 0; w < 4; ++w)
        windows.emplace_back([&, w] {
          for (int i = 0; i < 300 || (taken <= 10 && i < 30'000); ++i) {
            const double value = (w * 300 + i) % 100;
            if (w % 2 == 0) taken += live.set<"thinker">({value, false, value});
            else taken += live.set<"robot">({value, false, value});
            if (i % 50 == 0) taken += i % 100 == 0 ? live.stop("thinker") : live.start("thinker");
            for (const char* const path : {"robot.y", "thinker.y", "planner.y"})
              if (const auto seen = live.newest(path)) torn += seen->values[0] != seen->values[1];
            std::this_thread::sleep_for(200us);
          }
          if (--running == 0) live.end_run();
        });
      d.run(cca::without_end{}, pace, live);
      for (auto& each : windows) each.join();
      CHECK_EQ(torn, 0);
      CHECK_GT(taken, 10);
      CHECK(live.is_taken());
      CHECK_EQ(d.get<"thinker">().broken, 0);
      CHECK_EQ(d.get<"robot">().broken, 0);
      CHECK_EQ(d.state(), cca::state::started);
    });
  }

  TEST_CASE("the run ends while environments sleep: all go on with the beat of the one loop") {
    both_paces([](auto pace) {
      for (const std::int64_t end : {1, 3, 6, 12, 14}) {
        CAPTURE(end);
        started_one c;
        played& d = c;
        cca::controller<watched_graph> one;
        one.load();
        one.start();
        const auto until_end = [end](auto& running) { return running.beat_index() < end; };
        d.run(cca::without_end{}, pace, until_end);
        one.run(cca::without_end{}, cca::as_fast_as_possible{}, until_end);
        CHECK_EQ(d.beat_index(), end);
        d.run(cca::for_beats<20>{});
        one.run(cca::for_beats<20>{});
        CHECK_EQ(d.beat_index(), end + 20);
        CHECK_EQ(d.get<"robot">().value, one.get<"robot">().value);
        if constexpr (std::is_same_v<decltype(pace), cca::as_fast_as_possible>) {
          CHECK_EQ(d.get<"thinker">().value, one.get<"thinker">().value);
          CHECK_EQ(d.get<"planner">().value, one.get<"planner">().value);
          CHECK_EQ(d.get<"planner">().last, one.get<"planner">().last);
        }
      }
    });
  }
}
