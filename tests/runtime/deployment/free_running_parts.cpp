// Parts of free-running environments: in a fast run they stop and start as in one loop, in a wall-clock
// run when their cycle ends.
#include <doctest/doctest.h>

#include <cstdint>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <cca/runtime/live/live_access.hpp>

#include "free_running_parts.hpp"
#include "same_story.hpp"

using namespace free_parts;

namespace {

template <class Played>
std::string told(const Played& c) {
  std::ostringstream text;
  text << std::hexfloat << c.beat_index() << ' ' << cca::to_string(c.state()) << ' '
       << c.template get<"robot">().command;
  const auto tell = [&](const char* name, const auto& one) {
    text << '\n'
         << name << ' ' << one.hash << ' ' << one.dt << ' ' << one.fired << ' ' << one.fresh << ' '
         << one.starts << ' ' << one.stops;
  };
  tell("eyes", c.template get<"eyes">());
  tell("look", c.template get<"sight.look">());
  tell("again", c.template get<"sight.again">());
  tell("judge", c.template get<"sight.judge">());
  tell("steady", c.template get<"steady">());
  tell("last", c.template get<"last">());
  text << "\nbrief " << c.template get<"brief">().hash << ' ' << c.template get<"brief">().calls;
  for (const char* part : {"eyes", "sight", "brief", "steady"}) text << ' ' << c.is_stopped(part);
  return text.str();
}

}  // namespace

static_assert(cca::well_formed<spread<>>);

TEST_SUITE("deployed free-running parts") {
  TEST_CASE("in a fast run they stop and start as in one loop") {
    const auto plays = [](auto& c, auto tell) {
      c.load();
      c.start();
      for (int i = 0; i < 40; ++i) {
        c.step();
        tell();
      }
      c.run(cca::for_beats<101>{});
      tell();
      c.template stop<"eyes">();
      c.template stop<"sight">();
      tell();
      c.run(cca::for_beats<2>{});
      tell();
      c.template start<"eyes">();
      tell();
      c.run(cca::for_beats<3>{});
      tell();
      c.template start<"sight">();
      for (int i = 0; i < 20; ++i) c.run(cca::for_some_beats{i % 4});
      tell();
      int beats = 0;
      c.run(cca::without_end{}, cca::as_fast_as_possible{}, [&](auto& running) {
        if (beats == 3) running.template stop<"eyes">();
        if (beats == 6) running.template start<"eyes">();
        return ++beats < 10;
      });
      tell();
      c.stop();
      c.start();
      c.run(cca::for_beats<20>{});
      tell();
    };
    same_story::check<architecture, spread<>>(plays, [](const auto& c) { return told(c); });
  }

  TEST_CASE("in a wall-clock run a part stops when its cycle ends, and a run in a fast run goes on") {
    for (const std::int64_t us : {0, 2'500}) {
      const cycles_of these(us);
      cca::deployed<spread<cca::tolerate<100000>>> d;
      d.load();
      d.start();
      d.run(cca::for_beats<300>{}, cca::at_wall_clock());
      const auto& eyes = d.get<"eyes">();
      CAPTURE(us);
      CHECK_GT(eyes.fired, 20);
      CHECK_GT(eyes.stops, 3);
      CHECK_GE(eyes.starts, eyes.stops);
      // In the beats in which it rested nothing counts: after each start the time begins anew.
      CHECK_LT(eyes.dt, 0.001 * static_cast<double>(d.beat_index()));
      const auto& look = d.get<"sight.look">();
      CHECK_GT(look.stops, 3);
      CHECK_GE(look.starts, look.stops);
      CHECK_GT(d.get<"brief">().calls, 3);
      // Stopped as a whole, it rests.
      d.stop<"eyes">();
      d.stop<"sight">();
      const std::int64_t before = look.fired;
      d.run(cca::for_beats<1>{});
      CHECK_EQ(look.fired, before);
      d.start<"sight">();
      d.start<"eyes">();
      cycle_in_us = 0;
      d.run(cca::for_beats<2>{});
      CHECK_GT(look.fired, before);
    }
  }

  TEST_CASE("from outside, while it runs in a wall-clock run") {
    const cycles_of slow(700);
    cca::deployed<spread<cca::tolerate<100000>>> d;
    d.load();
    d.start();
    cca::live_access live(d);
    std::int64_t fired = -1, later = -1;
    std::thread window([&] {
      while (live.beat_index() < 20) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      while (!live.stop("sight")) {}
      while (live.beat_index() < 120) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      live.end_run();
    });
    d.run(cca::without_end{}, cca::at_wall_clock(), live);
    window.join();
    fired = d.get<"sight.look">().fired;
    later = d.get<"sight.again">().fired;
    CHECK_GT(fired, 0);
    CHECK_EQ(fired, later);  // both in one cycle
    CHECK_EQ(d.state(), cca::state::started);
  }
}
