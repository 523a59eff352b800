// Any described robot in the simulator, as a graph to be used in any other:
//
//   cca::node<"robot", cca::sim::robot<cca::robots::arm::description>>
//
// Its ports follow from the description (cca/robots/ports.hpp): "angles", "velocities", "torques" and its
// sensors out, the commands of its drives in, each optional. Set its world before the start:
//
//   controller.get<"robot.simulator">().put_down(cca::sim::robot_world(cca::sim::model_of<R>(), room));
//
// Errors: robot.unlimited_command, where a command arrives without a limiter; space.missing_limits;
// robot.description. Cost: a beat of physics; nothing of the graph is left in the
// loop. Example: tests/runtime/any_robot/arm.cpp; docs/robots.md.
#pragma once

#include <cca/robot/body_dynamics.hpp>  // not needed here, but by most programs with a simulated robot
#include <cca/robots/ports.hpp>
#include <cca/sim/robot/robot_graph.hpp>
#include <cca/sim/robot/simulated_robot.hpp>
