// The servos of the Oncilla's joints: each follows a target within the torque-speed line of its motor. The
// knee's winch is in robot/cable_winch.hpp.
#pragma once

#include <cca/sim/robot/cable_winch.hpp>
#include <cca/sim/robot/motor_torque.hpp>

namespace cca::sim {

struct servo_gains {
  double stiffness;  // N m/rad
  double damping;    // N m s/rad
};

inline double servo_torque(
    motor_line line, servo_gains g, double angle_error, double speed_error, double speed) {
  return limit_torque(line, g.stiffness * angle_error + g.damping * speed_error, speed);
}

}  // namespace cca::sim
