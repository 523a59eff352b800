// The architecture in the simulator, and what a program says about a run.
#pragma once

#include <cstdio>

#include <cca/graph/items/shows.hpp>
#include <cca/sim/robot.hpp>

#include "architecture.hpp"

namespace my_robot {

struct simulated : architecture<cca::sim::robot<description>> {};
static_assert(cca::check<simulated>());  // the first mistake of the graph, in a sentence

// What recordings and pages show.
struct shown : cca::shows<body, "robot.angles"> {};

// The arm stands on a floor. Add tables, walls and balls to the scene.
template <class Controller>
void put_down(Controller& c) {
  cca::sim::scene room;
  room.floor = 0;
  c.template get<"robot.simulator">().put_down(
      cca::sim::robot_world(cca::sim::model_of<description>(), room));
}

// How far the hand is from its way, m.
template <class Controller>
double error_of(Controller& c) {
  circle way = c.template get<"way">();
  const auto [pose, motion] = way.process(cca::beat(c.beat_index(), c.period(), 1));
  const Eigen::Vector3d wanted = pose.vector().template head<3>();
  return (c.template get<"robot.simulator">().world().end("arm").where.at - wanted).norm();
}

template <class Controller>
void report(Controller& c) {
  const auto& at = c.template get<"robot.simulator">().world().end("arm").where.at;
  std::printf("after %.1f s: hand at %.3f, %.3f, %.3f m, %.1f mm from its way\n",
              1e-9 * static_cast<double>(c.beat_index() * c.period()), at[0], at[1], at[2],
              1000 * error_of(c));
}

}  // namespace my_robot
