#pragma once
// One run of the learned gait in the simulator.
#include <string>

#include <cca/cca.hpp>
#include <cca/main/command_line.hpp>
#include <cca/sim/oncilla/disturbance.hpp>
#include <cca/sim/oncilla.hpp>
#include <cca/sim/engine/terrain.hpp>

#include "../trot/report/recording.hpp"
#include "../trot/rollout.hpp"
#include "architecture.hpp"
#include "teacher.hpp"
#include "way.hpp"

namespace walking {

struct simulated : architecture<cca::sim::oncilla> {};
using controller = cca::controller<simulated>;

// Puts the robot down where its teacher stands, and begins to record. The controller must be loaded and not
// started.
template <class Controller>
trot::recording begin(Controller& c,
                      const cca::sim::terrain& ground,
                      const cca::sim::disturbance& disturbance,
                      double seconds,
                      const cca::sim::robot_world_settings& physics = {}) {
  return trot::begin(c, teacher().p, ground, disturbance, seconds, physics);
}

template <class Controller>
void command_speed(Controller& c, double speed) {
  auto wanted = c.template get<"gait.throttle">().p;
  wanted.speed = speed;
  c.template set<"gait.throttle">(wanted);
}

template <class Controller>
void command_turn(Controller& c, double turn) {
  auto wanted = c.template get<"gait.helm">().p;
  wanted.turn = turn;
  c.template set<"gait.helm">(wanted);
}

template <class Controller>
void command_walk(Controller& c, const command& wanted) {
  command_speed(c, wanted.speed);
  command_turn(c, wanted.turn);
}

// A whole run (trot::walked).
template <class Controller, class Between>
trot::recording roll_out(Controller& c,
                         const cca::sim::terrain& ground,
                         const cca::sim::disturbance& disturbance,
                         double seconds,
                         Between between,
                         const cca::sim::robot_world_settings& physics = {}) {
  return trot::walked(c, begin(c, ground, disturbance, seconds, physics), seconds, between);
}

template <class Controller>
void name_weights(Controller& c, const std::string& file) {
  if (!c.template get<"gait.policy">().p.file.assign(file))
    throw cca::command_line_error(file + ": this name is too long");
}

}  // namespace walking
