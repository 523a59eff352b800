// The simulated Oncilla as a graph to be used in any other: `cca::node<"robot", cca::sim::oncilla>`.
//
// Ports, nodes and wires are those of every Oncilla: cca/robots/oncilla/robot.hpp. The real robot takes its
// place with the same ports (cca/hardware/oncilla.hpp).
//
// Errors: robot.unlimited_command, where a command reaches "command" without a limiter. Cost: nothing of the
// graph is left in the loop.
#pragma once

#include <cca/robots/oncilla/robot.hpp>

#include <cca/sim/oncilla_spaces.hpp>
#include <cca/sim/resource_nodes.hpp>
#include <cca/sim/simulator.hpp>

namespace cca::sim {

struct oncilla : robots::oncilla::robot<"simulator", simulator, "simulator", joint_node, trunk_node> {};

}  // namespace cca::sim
