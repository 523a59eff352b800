// A robot with eyes that run freely: two components without delays to and from the robot's loop and to a
// third environment.
#pragma once

#include <atomic>
#include <cstdint>
#include <tuple>

#include <cca/deployment.hpp>

#include "cycle_time.hpp"
#include "robot_and_mind.hpp"

namespace deployment_test {

using free_cycles::cycle_hangs;
using free_cycles::cycle_in_us, free_cycles::cycles_of, free_cycles::take_time;
inline std::atomic<std::int64_t> cycles_begun{0};

// Finds the level in what was measured, and now and then something that is worth a glance.
struct eyes {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, most), (double, gain));
  };
  parameters p{1e9, 0.5};
  double kept = 0, seconds = 0;
  std::int64_t cycles = 0, fresh = 0, first = -1, last = -1, oldest_age = 0;
  bool went_back = false;

  auto process(cca::in<"image", state> image, cca::beat now)
      -> std::tuple<cca::out<"level", level>, cca::maybe<"glance", level>, cca::fault> {
    ++cycles;
    ++cycles_begun;
    if (first < 0) first = now.index();
    fresh += image.fresh();
    seconds += now.dt();
    went_back = went_back || now.index() < last;
    last = now.index();
    kept += p.gain * (image[cca::x{}] - kept) + 0.001 * image[cca::y{}];
    take_time();
    return {kept,
            cycles % 7 == 3 ? cca::maybe<"glance", level>(static_cast<double>(cycles))
                            : cca::maybe<"glance", level>(),
            kept > p.most ? cca::fault("dazzled") : cca::fault()};
  }
};
// Reads what the eyes publish in the same cycle, and in the cycle before.
struct memory {
  double sum = 0;
  auto process(cca::in<"now", level> now, cca::in<"before", level> before) -> cca::out<"sum", level> {
    sum += now[cca::x{}] - before[cca::x{}];
    return sum;
  }
};
struct reflex {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, most));
  };
  parameters p{1e9};
  std::int64_t seen = 0, glances = 0;
  auto process(cca::in<"measured", state> is, cca::in<"level", level> seen_level, cca::in<"sum", level> sum)
      -> std::tuple<cca::out<"y", level>, cca::fault> {
    seen += seen_level.fresh();
    const double y = 0.1 * is[cca::x{}] - 0.2 * seen_level[cca::x{}] + 0.01 * sum[cca::x{}];
    return {y, y > p.most ? cca::fault("too much") : cca::fault()};
  }
};
struct glancer {
  std::int64_t glances = 0;
  double last = 0;
  auto process(cca::in<"glance", level> glance, cca::in<"level", level> seen) -> cca::out<"y", level> {
    glances += glance.fresh();
    last = glance[cca::x{}] + seen[cca::x{}];
    return last;
  }
};
// Hears the eyes, from another environment and without delay.
struct watcher {
  double sum = 0;
  auto process(cca::observe<"eyes.*"> heard) -> cca::out<"y", level> {
    for (const auto& one : heard)
      if (one.fresh) sum += one.values[0];
    return sum;
  }
};
struct curious {
  double sum = 0;
  auto process(cca::in<"x", level> x) -> cca::out<"y", level> { return sum += x[cca::x{}]; }
};

struct seeing
    : cca::graph<cca::rate<1000>,
                 cca::node<"device", device>,
                 cca::node<"memory", memory, cca::full_speed>,
                 cca::node<"reflex", reflex>,
                 cca::node<"eyes", eyes, cca::full_speed>,
                 cca::node<"glancer", glancer>,
                 cca::node<"slow", curious, cca::timed<7, 3>>,
                 cca::node<"watcher", watcher>,
                 cca::node<"log", curious>,
                 cca::node<"history", curious, cca::full_speed>,
                 cca::wire<"device.measured", "eyes.image">,
                 cca::wire<"device.measured", "reflex.measured">,
                 cca::wire<"eyes.level", "memory.now">,
                 cca::wire<"eyes.level", "memory.before", cca::delayed<1>>,
                 cca::wire<"eyes.level", "reflex.level">,
                 cca::wire<"memory.sum", "reflex.sum", cca::delayed<2>, cca::initial<0.5>>,
                 cca::wire<"eyes.glance", "glancer.glance">,
                 cca::wire<"eyes.level", "glancer.level", cca::delayed<3>>,
                 cca::wire<"memory.sum", "slow.x", cca::latest>,
                 cca::wire<"eyes.level", "log.x", cca::delayed<2>, cca::queue<8, cca::drop_oldest>>,
                 cca::wire<"reflex.y", "history.x", cca::delayed<1>, cca::queue<4, cca::drop_oldest>>,
                 cca::wire<"reflex.y", "device.command">,
                 cca::observe<"device.measured">,
                 cca::observe<"eyes.*">,
                 cca::observe<"memory.sum">,
                 cca::observe<"glancer.y">,
                 cca::observe<"slow.y">,
                 cca::observe<"history.y">,
                 cca::observe<"reflex.y">> {};

// [deployment]
struct with_eyes
    : cca::deployment<seeing,
                      cca::environment<"robot", cca::nodes<"device", "reflex">>,
                      cca::environment<"eyes", cca::nodes<"eyes", "memory", "history">, cca::free_running>,
                      cca::environment<"mind", cca::other_nodes>> {};
// [deployment end]

}  // namespace deployment_test
