// A cable that a motor winds. It pulls its joint towards larger angles or hangs slack; what pulls back is a
// spring or a weight.
//
// A position command is the angle to which the motor winds it: there the cable gets slack. A torque command,
// without a position, pulls with that torque. A cable without stiffness is none.
#pragma once

#include <cca/base/compiler.hpp>

namespace cca::robots {

struct cable_drive {
  double stiffness = 0;  // N m/rad
  double damping = 0;    // N m s/rad
};

}  // namespace cca::robots
