// The architecture in the simulator, and what a program says about a run.
#pragma once

#include <cmath>
#include <cstdio>

#include <cca/graph/items/shows.hpp>
#include <cca/sim/robot.hpp>

#include "architecture.hpp"

namespace my_robot {

struct simulated : architecture<cca::sim::robot<description>> {};
static_assert(cca::check<simulated>());  // the first mistake of the graph, in a sentence

// What recordings and pages show.
struct shown : cca::shows<body, "robot.angles"> {};

// The robot is alone. A scene has a floor, tables, walls and balls; cca's docs/robots.md.
template <class Controller>
void put_down(Controller& c) {
  c.template get<"robot.simulator">().put_down(
      cca::sim::robot_world(cca::sim::model_of<description>(), cca::sim::scene{}));
}

struct joint_error {
  Eigen::Index joint = 0;
  double error = 0;  // rad, m
};

// The joint with a motor that is farthest from its place.
template <class Controller>
joint_error worst_joint(Controller& c) {
  sway plan = c.template get<"plan">();
  const auto [wanted, speed] = plan.process(cca::beat(c.beat_index(), c.period(), 1));
  joint_error worst;
  for (Eigen::Index joint = 0; joint < wanted.vector().size(); ++joint) {
    if (!has_motor(joint)) continue;
    const auto& world = c.template get<"robot.simulator">().world();
    const double error =
        std::abs(wanted.vector()[joint] - world.joints()[static_cast<std::size_t>(joint)].angle);
    if (error >= worst.error) worst = {joint, error};
  }
  return worst;
}

template <class Controller>
const char* name_of(const Controller& c, Eigen::Index joint) {
  return c.template get<"robot.simulator">()
      .world()
      .model()
      .names.joints[static_cast<std::size_t>(joint)]
      .c_str();
}

template <class Controller>
void report(Controller& c) {
  const auto& world = c.template get<"robot.simulator">().world();
  if (world.trouble()) return static_cast<void>(std::printf("%s\n", world.trouble_text().c_str()));
  const joint_error worst = worst_joint(c);
  std::printf("after %.1f s: %s is farthest from its place, by %.4f rad\n", world.time(),
              name_of(c, worst.joint), worst.error);
}

}  // namespace my_robot
