// A motor that winds a cable (cca/robots/cable_drive.hpp).
//
// Plain arithmetic on a few numbers of a world's state, without the engine.
#pragma once

#include <algorithm>

#include <cca/robots/cable_drive.hpp>
#include <cca/sim/robot/model/motor_torque.hpp>

namespace cca::sim {

// The cable can only pull, or hang slack.
//
// The pulley goes to each new target at a constant speed, within a beat. To jump there in one physics step
// would jerk the cable at a speed that grows as the step gets shorter, and no step would be short enough.
struct cable_winch {
  double position = 0;  // the wound cable as an angle of the joint, rad
  double wanted = 0;    // the speed that reaches the target in a beat, rad/s
  double speed = 0;
  double torque = 0;  // of the last pull, >= 0

  void aim(double target, double beat) { wanted = (target - position) / beat; }

  void wind(motor_line motor, double dt) {
    speed = std::clamp(wanted, -motor.no_load_speed, available_speed(motor, torque));
    position += speed * dt;
  }

  double pull(motor_line motor, robots::cable_drive cable, double angle, double joint_speed) {
    const double stretch = position - angle;
    torque = stretch > 0 ? std::clamp(cable.stiffness * stretch + cable.damping * (speed - joint_speed), 0.0,
                                      motor.torque)
                         : 0.0;
    return torque;
  }

  // Pulls with a torque: the pulley goes wherever it has to.
  double pull_with(motor_line motor, double wanted_torque, double angle, double joint_speed) {
    torque = std::max(0.0, limit_torque(motor, wanted_torque, joint_speed));
    position = angle, speed = joint_speed;
    return torque;
  }
};

}  // namespace cca::sim
