// A described robot in the Open Dynamics Engine as a plant: plant_in_world.hpp, with robot_world for its
// world.
//
//   cca::hardware::virtual_hardware<my_arm, cca::sim::plant<description>> far(...);
#pragma once

#include <cca/sim/robot/plant_in_world.hpp>
#include <cca/sim/robot/world/robot_world.hpp>
