#pragma once
// One run of the learned gait in the simulator.
#include <cmath>
#include <cstddef>
#include <string>

#include <cca/cca.hpp>
#include <cca/main/command_line.hpp>
#include <cca/sim/disturbance.hpp>
#include <cca/sim/oncilla.hpp>
#include <cca/sim/terrain.hpp>
#include <cca/sim/world.hpp>

#include "../trot/gait.hpp"
#include "../trot/report/goes_on.hpp"
#include "../trot/report/recording.hpp"
#include "../trot/rollout.hpp"
#include "architecture.hpp"

namespace walking {

struct simulated : architecture<cca::sim::oncilla> {};
using controller = cca::controller<simulated>;

// Puts the robot down where the trot stands, and begins to record. The controller must be loaded and not
// started.
template <class Controller>
trot::recording begin(Controller& c,
                      const cca::sim::terrain& ground,
                      const cca::sim::disturbance& disturbance,
                      double seconds) {
  auto& simulator = c.template get<"robot.simulator">();
  simulator.put_down(cca::sim::world(cca::sim::oncilla_defaults, ground.with_friction(disturbance.friction),
                                     trot::put_down(trot::gait().p, disturbance)),
                     disturbance);
  trot::recording run;
  run.begin(simulator.world(), trot::beats_in(seconds));
  return run;
}

template <class Controller>
void command_speed(Controller& c, double speed) {
  auto wanted = c.template get<"gait.throttle">().p;
  wanted.speed = speed;
  c.template set<"gait.throttle">(wanted);
}

// A whole run, as fast as possible, until the robot falls or between() returns false.
template <class Controller, class Between>
trot::recording roll_out(Controller& c,
                         const cca::sim::terrain& ground,
                         const cca::sim::disturbance& disturbance,
                         double seconds,
                         Between between) {
  trot::recording run = begin(c, ground, disturbance, seconds);
  const std::size_t beats = trot::beats_in(seconds);
  c.start();
  for (std::size_t k = 1; k <= beats && !run.fell && c.step(); ++k) {
    run.note(c.template get<"robot.simulator">().world());
    if (!trot::goes_on(between)) break;
  }
  return run;
}

template <class Controller>
void name_weights(Controller& c, const std::string& file) {
  if (!c.template get<"gait.policy">().p.file.assign(file))
    throw cca::command_line_error(file + ": this name is too long");
}

}  // namespace walking
