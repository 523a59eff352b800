// Components and inner graphs of free-running environments that are stopped and started: by components of any
// environment, by themselves and from outside.
#pragma once

#include <cmath>
#include <cstdint>
#include <tuple>

#include <cca/deployment.hpp>

#include "cycle_time.hpp"

namespace free_parts {

struct number : cca::space<cca::number, cca::axes<cca::x>> {};

using free_cycles::cycle_in_us, free_cycles::cycles_of, free_cycles::take_time;

struct robot {
  double n = 0, command = 0;
  auto sense(cca::beat) -> cca::out<"y", number> { return std::sin(0.1 * ++n) + 0.01 * command; }
  void act(cca::in<"command", number> to) { command = to[cca::x{}]; }
};
// Stops and starts the parts, now and then.
struct orders {
  double calls = 0;
  auto process(cca::in<"x", number> x) -> std::tuple<cca::out<"y", number>,
                                                     cca::stops<"eyes">,
                                                     cca::starts<"eyes">,
                                                     cca::stops<"sight">,
                                                     cca::starts<"sight">> {
    const int n = static_cast<int>(++calls);
    return {x[cca::x{}], n % 17 == 5, n % 17 == 11, n % 23 == 7, n % 23 == 9 || n % 23 == 20};
  }
};
// What it shows depends on all that it has seen.
template <bool TakesLong>
struct looks {
  double hash = 0, dt = 0;
  std::int64_t fired = 0, fresh = 0, starts = 0, stops = 0;
  auto process(cca::in<"x", number> x, cca::beat now) -> cca::out<"y", number> {
    ++fired;
    fresh += x.fresh();
    dt += now.dt();
    hash = std::fmod(
        1.3 * hash + x[cca::x{}] + (x.fresh() ? 0.5 : 0) + now.dt() + 1e-9 * static_cast<double>(x.origin()),
        1e3);
    if (TakesLong) take_time();
    return hash;
  }
  void on_start() { ++starts; }
  void on_stop() { ++stops; }
};
using looker = looks<false>;
using eyes = looks<true>;
// Stops itself after some cycles, and another component starts it again.
struct brief {
  double hash = 0;
  int calls = 0;
  auto process(cca::in<"x", number> x) -> std::tuple<cca::out<"y", number>, cca::done> {
    hash = std::fmod(1.7 * hash + x[cca::x{}], 1e3);
    return {hash, ++calls % 4 == 0};
  }
};
struct waker {
  int calls = 0;
  auto process(cca::in<"x", number>)
      -> std::tuple<cca::starts<"brief">, cca::stops<"steady">, cca::starts<"steady">> {
    ++calls;
    return {calls % 9 == 0, calls % 13 == 0, calls % 13 == 4};
  }
};
struct sight : cca::graph<cca::node<"look", eyes, cca::full_speed>,
                          cca::node<"again", looker, cca::full_speed>,
                          cca::node<"judge", looker, cca::timed<2>>,
                          cca::wire<"look.y", "again.x", cca::delayed<1>>,
                          cca::wire<"again.y", "judge.x", cca::queue<4>>,
                          cca::expose<"look.x", "x">,
                          cca::expose<"judge.y", "y">> {};

struct architecture : cca::graph<cca::rate<1000>,
                                 cca::node<"robot", robot>,
                                 cca::node<"orders", orders>,
                                 cca::node<"eyes", eyes, cca::stoppable<cca::full_speed>>,
                                 cca::node<"sight", sight, cca::stoppable<>>,
                                 cca::node<"brief", brief, cca::stoppable<cca::full_speed>>,
                                 cca::node<"waker", waker, cca::full_speed>,
                                 cca::node<"steady", looker, cca::stoppable<>>,
                                 cca::node<"last", looker>,
                                 cca::wire<"robot.y", "orders.x">,
                                 cca::wire<"robot.y", "eyes.x">,
                                 cca::wire<"robot.y", "sight.x">,
                                 cca::wire<"eyes.y", "brief.x">,
                                 cca::wire<"eyes.y", "waker.x">,
                                 cca::wire<"brief.y", "steady.x">,
                                 cca::wire<"sight.y", "last.x", cca::delayed<4>>,
                                 cca::wire<"eyes.y", "robot.command", cca::delayed<1>>> {};

template <class... Options>
struct spread
    : cca::deployment<architecture,
                      cca::environment<"robot", cca::nodes<"robot", "orders", "last">>,
                      cca::environment<"eyes",
                                       cca::nodes<"eyes", "sight.look", "sight.again", "brief", "waker">,
                                       cca::free_running>,
                      cca::environment<"mind", cca::other_nodes>,
                      Options...> {};

}  // namespace free_parts
