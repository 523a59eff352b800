// Other threads look at a controller of modes that runs, and ask it for changes and for modes.
#include <doctest/doctest.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include <cca/config.hpp>
#include <cca/modes.hpp>
#include <cca/runtime/live/live_access.hpp>

#include "../core/live_rig.hpp"

using namespace live_test;

namespace {

struct trips {
  auto process(cca::in<"x", pair>) -> cca::fault { return tripped ? cca::fault("tripped") : cca::fault(); }
  bool tripped = false;
};

using may_stop = cca::stoppable<cca::timed<1>>;
struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"gait", source, may_stop>,
                         cca::node<"both", source, may_stop>,
                         cca::node<"trips", trips>,
                         cca::wire<"both.y", "trips.x">,
                         cca::observe<"gait.y">,
                         cca::observe<"both.y">> {};
struct stand : cca::graph<cca::rate<1000>,
                          cca::node<"both", source, may_stop>,
                          cca::node<"trips", trips>,
                          cca::node<"stance", source, may_stop>,
                          cca::wire<"both.y", "trips.x">,
                          cca::observe<"stance.y">,
                          cca::observe<"both.y">> {};
struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"stand", stand>> {};
using played = cca::controller<legs>;

void step(played& c, cca::live_access<played>& live) {
  c.run(cca::for_beats<1>{}, cca::as_fast_as_possible{}, live);
}

}  // namespace

TEST_SUITE("live access to modes") {
  TEST_CASE("a window in another thread") {
    const auto show = [](double) {};
    // [live]
    cca::controller<legs> c;
    c.load();
    c.start();
    cca::live_access live(c);
    std::thread window([&] {
      while (!live.switch_to("stand")) {}  // taken between two beats
      while (live.mode() != "stand" && live.state() != cca::state::faulted) {}
      if (const auto seen = live.newest("stance.y")) show(seen->values[0]);
      live.end_run();
    });
    c.run(cca::for_<10>{}, cca::at_wall_clock(), live);
    window.join();
    // [live end]
    CHECK_EQ(c.mode(), "stand");
    CHECK(c.beat_index() < 10'000);
  }

  TEST_CASE("outputs of all modes: of one that is not active the last sample stays") {
    auto c = started<played>();
    cca::live_access live(c);
    CHECK_EQ(live.mode(), "walk");
    CHECK_FALSE(live.newest("stance.y"));
    step(c, live);
    step(c, live);
    CHECK_EQ(live.newest("gait.y")->values[0], 2);
    CHECK_EQ(live.newest("both.y")->values[0], 2);
    CHECK_FALSE(live.newest("stance.y"));
    CHECK(live.switch_to<"stand">());
    step(c, live);
    CHECK_EQ(live.mode(), "stand");
    CHECK_EQ(live.refused_by(), "");
    step(c, live);
    CHECK_EQ(live.newest("gait.y")->values[0], 3);
    CHECK_EQ(live.newest("both.y")->values[0], 4);
    CHECK_EQ(live.newest("stance.y")->values[0], 1);
    CHECK_EQ(refusal([&] { (void)live.newest("stanc.y"); }),
             "cca::live_access: newest: there is no output `stanc.y`; did you mean `stance.y`?");
    CHECK_EQ(c.get<"gait">().stops, 1);
    CHECK_EQ(c.get<"stance">().starts, 1);
  }

  TEST_CASE("a run of no beats takes the request that waits") {
    auto c = started<played>();
    cca::live_access live(c);
    CHECK(live.switch_to("stand"));
    c.run(cca::for_beats<0>{}, cca::as_fast_as_possible{}, live);
    CHECK(live.is_taken());
    CHECK_EQ(live.mode(), "stand");
    CHECK_EQ(c.mode(), "stand");
  }

  TEST_CASE("parameters of all modes, active or not") {
    auto c = started<played>();
    cca::live_access live(c);
    CHECK(live.set("stance.slope", 5.0));
    CHECK_FALSE(live.switch_to("stand"));  // the first has not been taken
    step(c, live);
    CHECK(live.set<"gait">({6.0, true, 6.0}));
    step(c, live);
    CHECK_EQ(c.get<"stance">().p.slope, 5.0);
    CHECK_EQ(c.get<"gait">().p.slope, 6.0);
    CHECK(live.set("gait.slope", 7.0));
    step(c, live);
    CHECK_EQ(live.refused_by(), "gait");
    CHECK_EQ(live.parameter("gait.slope").value_or("busy"), "6.0");
  }

  TEST_CASE("what is wrong is refused in the thread that asks") {
    auto c = started<played>();
    cca::live_access live(c);
    CHECK_EQ(refusal([&] { live.switch_to("stnd"); }),
             "cca::controller: switch_to: legs has no mode `stnd`; did you mean `stand`?");
    CHECK(refusal([&] { live.stop("trips"); }).find("can't be stopped on its own") != std::string::npos);
    CHECK(live.is_taken());
  }

  TEST_CASE("what the active mode lacks is not stopped, and says so later") {
    auto c = started<played>();
    cca::live_access live(c);
    CHECK(live.stop("stance"));
    step(c, live);
    CHECK_EQ(live.refused_by(), "stance");
    CHECK_EQ(c.get<"stance">().stops, 0);
    CHECK(live.stop("gait"));
    CHECK_EQ(live.refused_by(), "");
    step(c, live);
    CHECK_EQ(c.get<"gait">().stops, 1);
    CHECK(c.is_stopped<"gait">());
    CHECK(live.start("gait"));
    step(c, live);
    CHECK_FALSE(c.is_stopped<"gait">());
  }

  TEST_CASE("after a fault no mode is switched to, and the loop does not throw") {
    auto c = started<played>();
    cca::live_access live(c);
    CHECK(live.switch_to("stand"));
    c.get<"trips">().tripped = true;
    step(c, live);
    CHECK_EQ(live.state(), cca::state::faulted);
    CHECK_EQ(std::string(live.fault().reason()), "tripped");
    CHECK_EQ(live.refused_by(), "stand");
    CHECK_EQ(live.mode(), "walk");
    CHECK_EQ(c.mode(), "walk");
  }

  TEST_CASE("windows in several threads that switch, set and look, on busy cores") {
    auto c = started<played>();
    cca::live_access live(c);
    const busy_cores load(2);
    std::atomic<int> torn{0}, taken{0}, running{4};
    std::vector<std::thread> windows;
    for (int w = 0; w < 4; ++w)
      windows.emplace_back([&, w] {
        for (int i = 0; i < 300; ++i) {
          const double value = (w * 300 + i) % 100;
          taken += live.set<"both">({value, false, value});
          if (i % 10 == 0) taken += live.switch_to(i % 20 == 0 ? "stand" : "walk");
          if (i % 50 == 0) taken += i % 100 == 0 ? live.stop("gait") : live.start("gait");
          for (const char* const path : {"gait.y", "both.y", "stance.y"})
            if (const auto seen = live.newest(path)) torn += seen->values[0] != seen->values[1];
          torn += live.mode() != "walk" && live.mode() != "stand";
          std::this_thread::sleep_for(200us);
        }
        if (--running == 0) live.end_run();
      });
    c.run(cca::without_end{}, cca::at_speed(5), live);
    for (auto& each : windows) each.join();
    CHECK_EQ(torn, 0);
    CHECK_GT(taken, 10);
    CHECK(live.is_taken());
    CHECK_EQ(c.get<"both">().broken, 0);
    CHECK_EQ(c.get<"stance">().broken + c.get<"gait">().broken, 0);
    CHECK_EQ(c.state(), cca::state::started);
  }
}
