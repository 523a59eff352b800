// A described robot in compiled physics as a plant: plant_in_world.hpp, without an engine.
//
//   cca::hardware::virtual_hardware<my_arm, cca::sim::plant<description, cca::sim::compiled>> far(...);
//
// Errors: robot.compiled. Cost: docs/physics.md. Example: tests/runtime/robot_on_drives/arm.cpp.
#pragma once

#include <cca/sim/compiled/robot.hpp>
#include <cca/sim/robot/plant_in_world.hpp>
