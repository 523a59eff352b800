// What a simulated drive does in a beat (cca/robots/joint_law.hpp), and what is read from its joint.
#pragma once

#include <cca/robots/joint_law.hpp>

namespace cca::sim {

using robots::joint_law;

struct joint_reading {
  double angle = 0;     // rad
  double velocity = 0;  // rad/s
  double torque = 0;    // N m of the motor, positive towards larger angles
};

}  // namespace cca::sim
