// What the drive of a joint does in a beat, simulated or real.
//
// The law is that of a drive with its own loop:
//   torque = stiffness (position - q) + damping (velocity - v) + torque
// Targets are not clamped to the joint's range: whoever commands such a drive must do that. A law that isn't
// finite is ignored by the simulator: its drive keeps the last one. Prismatic joints: m, m/s, N, N/m, N s/m.
#pragma once

#include <cmath>

namespace cca::robots {

struct joint_law {
  double position = 0;   // rad
  double velocity = 0;   // rad/s
  double torque = 0;     // N m
  double stiffness = 0;  // N m/rad
  double damping = 0;    // N m s/rad

  double operator()(double angle, double speed) const {
    return stiffness * (position - angle) + damping * (velocity - speed) + torque;
  }
  bool is_finite() const { return std::isfinite(position + velocity + torque + stiffness + damping); }
};

}  // namespace cca::robots
