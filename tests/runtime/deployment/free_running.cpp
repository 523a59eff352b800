// Free-running environments: in a fast run they change no bit; in a wall-clock run their cycles follow
// one another, and nobody waits for them.
#include <doctest/doctest.h>

#include <chrono>
#include <cstdint>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <cca/runtime/live/live_access.hpp>

#include "free_running.hpp"
#include "same_story.hpp"

using namespace deployment_test;

namespace {

using namespace std::chrono_literals;

template <class Played>
std::string told(const Played& c) {
  std::ostringstream text;
  const auto& eyes = c.template get<"eyes">();
  text << std::hexfloat << c.beat_index() << ' ' << cca::to_string(c.state()) << ' ' << c.fault().reason()
       << ' ' << c.fault_path() << ' ' << eyes.kept << ' ' << eyes.cycles << ' ' << eyes.fresh << ' '
       << eyes.seconds << ' ' << eyes.last << ' ' << c.template get<"memory">().sum << ' '
       << c.template get<"reflex">().seen << ' ' << c.template get<"glancer">().glances << ' '
       << c.template get<"glancer">().last << ' ' << c.template get<"slow">().sum << ' '
       << c.template get<"log">().sum << ' ' << c.template get<"history">().sum << ' '
       << c.template get<"watcher">().sum << ' ' << c.template get<"device">().command << ' '
       << c.template get<"device">().faults;
  same_story::tell_observed(text, c);
  return text.str();
}

template <class Deployment, class F>
void check_same(F plays) {
  same_story::check<seeing, Deployment>(plays, [](const auto& c) { return told(c); });
}

struct two_free
    : cca::deployment<seeing,
                      cca::environment<"robot", cca::nodes<"reflex", "slow", "device">>,
                      cca::environment<"memory", cca::nodes<"memory", "history">, cca::free_running>,
                      cca::environment<"mind", cca::nodes<"glancer", "log", "watcher">>,
                      cca::environment<"eyes", cca::other_nodes, cca::free_running>> {};

}  // namespace

static_assert(!cca::well_formed<cca::deployment<seeing,
                                                cca::environment<"robot", cca::nodes<"device", "reflex">>,
                                                cca::environment<"eyes", cca::other_nodes>>>);
static_assert(cca::diagnosis<cca::deployment<seeing, cca::environment<"robot", cca::nodes<"device", "reflex">>,
                                             cca::environment<"eyes", cca::other_nodes, cca::free_running>>>.rule ==
              "deployment.free_running");

TEST_SUITE("deployed free-running") {
  TEST_CASE("in a fast run all is as in one loop: runs, steps, what is seen between two beats") {
    const auto plays = [](auto& c, auto tell) {
      c.load();
      c.start();
      tell();
      c.step();
      tell();
      c.run(cca::for_beats<500>{});
      tell();
      for (int i = 0; i < 30; ++i) c.run(cca::for_some_beats{i % 4});
      tell();
      int beats = 0;
      c.run(cca::without_end{}, cca::as_fast_as_possible{}, [&](auto&) {
        tell();
        return ++beats < 40;
      });
      c.stop();
      c.start();
      c.run(cca::for_beats<20>{});
      tell();
    };
    check_same<with_eyes>(plays);
    check_same<two_free>(plays);
  }

  TEST_CASE("in a fast run a fault ends the beat where it ends the one loop, on either side") {
    const auto plays = [](auto& c, auto tell) {
      c.load();
      c.template set<"eyes">({0.0045, 0.5});
      c.start();
      c.run(cca::for_beats<300>{});
      tell();
      REQUIRE_EQ(c.fault_path(), "eyes");
      c.template set<"eyes">({1e9, 0.5});
      c.resume();
      c.run(cca::for_beats<3>{});
      tell();
      c.template set<"reflex">({-1e9});
      c.run(cca::for_beats<30>{});
      tell();
      REQUIRE_EQ(c.fault_path(), "reflex");
      c.template set<"reflex">({1e9});
      c.resume();
      c.run(cca::for_beats<30>{});
      tell();
    };
    check_same<with_eyes>(plays);
    check_same<two_free>(plays);
  }

  TEST_CASE("in a wall-clock run cycles follow one another without pause, in beats that never go back") {
    const cycles_of none(0);
    cca::deployed<with_eyes> d;
    d.load();
    d.start();
    d.run(cca::for_<0.2>{}, cca::at_wall_clock());
    const auto& eyes = d.get<"eyes">();
    CHECK_EQ(d.beat_index(), 200);
    CHECK_GT(eyes.cycles, 400);
    CHECK_FALSE(eyes.went_back);
    // The time of all cycles is that of the beats, however many there were in one. On a busy machine some
    // have passed before the first.
    CHECK_EQ(eyes.seconds, doctest::Approx(0.001 * static_cast<double>(eyes.last - eyes.first + 1)));
    CHECK_LT(eyes.first, 100);
    CHECK_LE(eyes.fresh, 200);
    CHECK_GT(eyes.fresh, 5);
    CHECK_GT(d.get<"reflex">().seen, 5);
    CHECK_LE(d.get<"reflex">().seen, 200);
    CHECK_EQ(d.figures()[1].channels[0].late, 0);
    CHECK_EQ(d.figures()[1].overruns, 0);
    CHECK_EQ(d.figures()[1].beat.count(), eyes.cycles);
  }

  TEST_CASE("a cycle of many beats is never late: no lost contact, no overrun, and its result arrives") {
    const cycles_of slow(25'000);
    cca::deployed<with_eyes> d;
    d.load();
    d.start();
    const auto since = std::chrono::steady_clock::now();
    d.run(cca::for_<0.3>{}, cca::at_wall_clock());
    const auto& eyes = d.get<"eyes">();
    CHECK_EQ(d.state(), cca::state::started);
    CHECK_GE(d.beat_index(), 300);
    CHECK_LE((eyes.cycles - 1) * 25ms, std::chrono::steady_clock::now() - since);
    CHECK_GT(eyes.cycles, 3);
    CHECK_GE(d.get<"reflex">().seen, eyes.cycles - 2);  // the last may end after the run
    CHECK_LE(d.get<"reflex">().seen, eyes.cycles);
    CHECK_EQ(d.figures()[1].overruns, 0);
    const auto figures = d.figures();
    for (const auto& channel : figures[0].channels)
      if (channel.from == "eyes") CHECK_EQ(channel.late, 0);
  }

  TEST_CASE("what a cycle publishes after the last beat of a run arrives in the next one") {
    const cycles_of slow(15'000);
    cca::deployed<with_eyes> d;
    d.load();
    d.start();
    for (int i = 0; i < 10; ++i) d.run(cca::for_beats<5>{}, cca::at_wall_clock());
    // On a busy machine a run may end before a cycle has begun.
    CHECK_GT(d.get<"eyes">().cycles, 3);
    CHECK_GT(d.get<"reflex">().seen, d.get<"eyes">().cycles / 2);
    // In a fast run what has not arrived never does: the eyes see anew in each beat.
    cycle_in_us = 0;
    const std::int64_t cycles = d.get<"eyes">().cycles, seen = d.get<"reflex">().seen;
    d.run(cca::for_beats<50>{});
    CHECK_EQ(d.get<"eyes">().cycles, cycles + 50);
    CHECK_EQ(d.get<"reflex">().seen, seen + 50);
  }

  TEST_CASE("a run ends and faults while a cycle hangs: the robot's side goes on until it has ended") {
    const cycles_of hanging(0);
    for (const bool by_fault : {false, true}) {
      cca::deployed<with_eyes> d;
      d.load();
      d.start();
      std::thread releases([since = cycles_begun.load(), idle = idle_beats.load()] {
        while (cycles_begun == since) std::this_thread::sleep_for(1ms);
        for (int i = 0; i < 20'000 && idle_beats <= idle + 10; ++i) std::this_thread::sleep_for(1ms);
        cycle_hangs = false;
      });
      cycle_hangs = true;
      std::int64_t beats = 0;
      d.run(cca::without_end{}, cca::at_wall_clock(), [&](auto& running) {
        if (by_fault && beats == 50) running.template set<"reflex">({-1e9});
        return ++beats < 100;
      });
      releases.join();
      CHECK_EQ(d.state(), by_fault ? cca::state::faulted : cca::state::started);
      CHECK_EQ(d.get<"device">().faults, by_fault ? 1 : 0);
      CHECK_GE(beats, by_fault ? 50 : 100);
      CHECK_GT(d.get<"device">().idles, 10);  // the cycle hung for so long
    }
  }

  TEST_CASE("a fault in a cycle is that of all") {
    const cycles_of slow(3'000);
    cca::deployed<with_eyes> d;
    d.load();
    d.set<"eyes">({-1e9, 0.5});
    d.start();
    d.run(cca::for_<5>{}, cca::at_wall_clock());
    CHECK_EQ(d.state(), cca::state::faulted);
    CHECK_EQ(d.fault_path(), "eyes");
    CHECK_EQ(d.get<"device">().faults, 1);
    d.set<"eyes">({1e9, 0.5});
    d.resume();
    d.run(cca::for_beats<30>{});
    CHECK_EQ(d.state(), cca::state::started);
  }

  TEST_CASE("in a pause it rests as all do, and each single beat lets it go on") {
    const cycles_of slow(500);
    cca::deployed<with_eyes> d;
    d.load();
    d.start();
    cca::live_access live(d);
    std::thread window([&] {
      while (cycles_begun == 0 || live.beat_index() < 20) std::this_thread::sleep_for(1ms);
      live.pause();
      while (!live.is_paused()) std::this_thread::sleep_for(1ms);
      std::this_thread::sleep_for(20ms);  // a cycle that has begun ends
      const std::int64_t before = cycles_begun;
      std::this_thread::sleep_for(100ms);
      CHECK_EQ(cycles_begun, before);
      live.step();
      for (int i = 0; i < 5000 && cycles_begun == before; ++i) std::this_thread::sleep_for(1ms);
      CHECK_GT(cycles_begun, before);
      live.go_on();
      live.end_run();
    });
    d.run(cca::without_end{}, cca::at_wall_clock(), live);
    window.join();
    CHECK_EQ(d.state(), cca::state::started);
  }

  TEST_CASE("slowed down and sped up: cycles take the time that they need") {
    const cycles_of slow(5'000);
    for (const double speed : {0.5, 4.0}) {
      cca::deployed<with_eyes> d;
      d.load();
      d.start();
      d.run(cca::for_beats<100>{}, cca::at_speed(speed));
      CHECK_GE(d.beat_index(), 100);
      CHECK_GE(d.get<"eyes">().cycles, speed > 1 ? 2 : 10);
    }
  }
}
