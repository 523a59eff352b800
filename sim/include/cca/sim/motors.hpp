// The motors: a servo that follows a target within a torque-speed line, and a winch that pulls a knee by a
// cable.
//
// Both are plain arithmetic on a few numbers of the world's state, without the engine.
#pragma once

#include <algorithm>
#include <cmath>

#include <cca/sim/oncilla_model.hpp>
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

// The knee's cable on its pulley. It can only pull: it flexes the knee or hangs slack. The spring extends the
// knee.
//
// The pulley goes to each new target at a constant speed, within a beat. To jump there in one physics step
// would jerk the cable at a speed that grows as the step gets shorter, and no step would be short enough.
struct cable_winch {
  double position = 0;  // the wound cable as an angle of the knee, rad
  double wanted = 0;    // the speed that reaches the target in a beat, rad/s
  double speed = 0;
  double torque = 0;  // of the last pull, >= 0

  void aim(double target, double beat) { wanted = (target - position) / beat; }

  void wind(const oncilla_model& m, double dt) {
    speed = std::clamp(wanted, -m.knee_motor.no_load_speed, available_speed(m.knee_motor, torque));
    position += speed * dt;
  }

  double pull(const oncilla_model& m, double knee, double knee_speed) {
    const double stretch = position - knee;
    torque = stretch > 0 ? std::clamp(m.cable_stiffness * stretch + m.cable_damping * (speed - knee_speed),
                                      0.0, m.knee_motor.torque)
                         : 0.0;
    return torque;
  }
};

}  // namespace cca::sim
