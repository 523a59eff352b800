// Two resource nodes in environments of their own, and a component in a third that faults. In a wall-clock
// run, slowed down, so that a busy machine changes nothing: how long after that `on_fault` runs.
#pragma once

#include <cstdint>
#include <tuple>

#include <cca/deployment.hpp>

#include "robot_and_mind.hpp"

namespace deployment_test {

struct alarm {
  std::int64_t raised_at = 0;  // by the clock of the machine, ns
  auto process(cca::in<"x", level>, cca::in<"z", level>, cca::beat now)
      -> std::tuple<cca::out<"y", level>, cca::fault> {
    if (now.index() < 12) return {0.0, cca::fault()};
    raised_at = cca::detail::monotonic_clock::now();
    return {0.0, cca::fault("alarm")};
  }
};

struct limb {
  std::int64_t stopped_at = 0;
  int stops = 0;
  auto sense(cca::beat) -> cca::out<"is", level> { return 0.0; }
  void act(cca::in<"command", level>) {}
  void on_fault() {
    stopped_at = cca::detail::monotonic_clock::now();
    ++stops;
  }
};

struct alarmed_limbs : cca::graph<cca::rate<1000>,
                                  cca::node<"arm", limb>,
                                  cca::node<"hand", limb>,
                                  cca::node<"alarm", alarm>,
                                  cca::wire<"arm.is", "alarm.x", cca::delayed<1>>,
                                  cca::wire<"hand.is", "alarm.z", cca::delayed<1>>,
                                  cca::wire<"alarm.y", "arm.command", cca::delayed<1>>,
                                  cca::wire<"alarm.y", "hand.command", cca::delayed<1>>> {};
struct alarmed : cca::deployment<alarmed_limbs,
                                 cca::environment<"arm", cca::nodes<"arm">>,
                                 cca::environment<"mind", cca::nodes<"alarm">>,
                                 cca::environment<"hand", cca::nodes<"hand">>,
                                 cca::tolerate<1000>> {};

constexpr double alarmed_speed = 0.01;
constexpr std::int64_t alarmed_beat = 100'000'000;  // ns of real time

}  // namespace deployment_test
