// The simulated Oncilla as a graph to be used in any other: `cca::node<"robot", cca::sim::oncilla>`.
//
// Its ports are those of cca/robots/oncilla/as_built.hpp; its world is cca::sim::world. The real robot takes
// its place with the same ports (cca/hardware/oncilla.hpp).
//
// Errors: robot.unlimited_command, where a command reaches "command" without a limiter. Cost: nothing of the
// graph is left in the loop.
#pragma once

#include <cca/robots/oncilla/as_built.hpp>
#include <cca/sim/oncilla/disturbance.hpp>
#include <cca/sim/robot.hpp>
#include <cca/sim/oncilla/simulator.hpp>
#include <cca/sim/oncilla/world.hpp>

namespace cca::sim {

struct oncilla : robot<robots::oncilla::as_built, world> {};

}  // namespace cca::sim
