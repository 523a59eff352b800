// What a motor can give: its torque-speed line (cca/robots/motor_line.hpp) applied to a wanted torque.
#pragma once

#include <algorithm>
#include <cmath>

#include <cca/robots/motor_line.hpp>

namespace cca::sim {

using robots::motor_line;

// The largest torque that a motor gives at a speed, in the direction of that speed.
inline double available_torque(motor_line line, double speed) {
  return line.torque * std::clamp(2 * (1 - std::abs(speed) / line.no_load_speed), 0.0, 1.0);
}

// The largest speed that a motor reaches against a load: the inverse of the same line.
inline double available_speed(motor_line line, double load) {
  if (load >= line.torque) return 0;
  return line.no_load_speed * (1 - std::max(load, 0.0) / (2 * line.torque));
}

// A motor brakes with its full torque, and drives with the torque that the line leaves.
inline double limit_torque(motor_line line, double torque, double speed) {
  const double limit = torque * speed > 0 ? available_torque(line, speed) : line.torque;
  return std::clamp(torque, -limit, limit);
}

}  // namespace cca::sim
