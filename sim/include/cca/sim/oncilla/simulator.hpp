// The synchronizer of the simulated Oncilla: simulated_robot.hpp, with cca::sim::world for its world.
#pragma once

#include <cca/robots/oncilla/as_built.hpp>
#include <cca/sim/oncilla/disturbance.hpp>
#include <cca/sim/robot/simulated_robot.hpp>
#include <cca/sim/oncilla/world.hpp>

namespace cca::sim {

using simulator = simulated_robot<robots::oncilla::as_built, world>;

}  // namespace cca::sim
