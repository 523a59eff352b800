// A motor's torque over its speed: full torque up to half of the no-load speed, then a line down to nothing.
//
// Units: N m and rad/s at the joint (prismatic joints: N and m/s). A line without torque is no motor.
#pragma once

#include <cca/base/compiler.hpp>

namespace cca::robots {

struct motor_line {
  double torque = 0;
  double no_load_speed = 1;
};

}  // namespace cca::robots
