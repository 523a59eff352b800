// A force that answers the motion of a coordinate: springs, dampers, servos, cables, motors.
//
//   force = pull - stiffness * (way of the step) - damping * speed, within [low, high]
//
// A step can take it at its beginning (explicit: `now`) or at its end (implicit: `after`). The explicit one
// is unstable where step * (damping + step * stiffness) is more than twice the inertia that it moves; the
// implicit one is stable for every number. Plain arithmetic, without the engine.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <cca/robots/description.hpp>
#include <cca/sim/robot/model/cable_winch.hpp>
#include <cca/sim/robot/model/joint_law.hpp>

namespace cca::sim {

struct soft_force {
  static constexpr double unlimited = std::numeric_limits<double>::infinity();

  double pull = 0;                    // where the coordinate is, at rest; N m (a slider: N)
  double stiffness = 0, damping = 0;  // N m/rad, N m s/rad
  double low = -unlimited, high = unlimited;
  bool ends_line = false;  // of a motor: where its torque falls with its speed

  double now(double speed) const { return std::clamp(pull - damping * speed, low, high); }
  // What a speed at the end of a step takes off, N m s/rad.
  double resistance(double step) const { return damping + step * stiffness; }
  double after(double speed, double step) const {
    return std::clamp(pull - resistance(step) * speed, low, high);
  }
};

// The friction and the spring in a joint.
inline soft_force passive_force(const robots::joint_drive& d, double q) {
  return {.pull = -d.spring * (q - d.spring_rest), .stiffness = d.spring, .damping = d.friction};
}

// The dry friction in a joint: whatever stops it in this step, within its torque.
inline soft_force dry_force(const robots::joint_drive& d) {
  constexpr double hard = 1e6;  // N m s/rad
  return {.damping = hard, .low = -d.dry_friction, .high = d.dry_friction};
}

// A motor that follows a law. Its torque is what the law says and what its line leaves, whichever is less.
// One force can stand for one of the two: the one that holds at the end of the step, as far as `mobility`
// (speed per N m s; an upper bound) tells.
inline soft_force motor_force(
    motor_line line, const joint_law& law, double q, double speed, double step, double mobility) {
  soft_force by_law{.pull = law.stiffness * (law.position - q) + law.damping * law.velocity + law.torque,
                    .stiffness = law.stiffness,
                    .damping = law.damping,
                    .low = -line.torque,
                    .high = line.torque};
  const double wanted = law(q, speed), resistance = by_law.resistance(step);
  const double change = wanted / (1 / (step * mobility) + resistance);
  const double end_speed = speed + change, end_torque = wanted - resistance * change;
  const double slope = 2 * line.torque / line.no_load_speed;
  if (end_torque > std::clamp(2 * line.torque - slope * end_speed, 0.0, line.torque))
    return {.pull = 2 * line.torque,
            .damping = slope,
            .low = 0,
            .high = std::clamp(wanted, 0.0, line.torque),
            .ends_line = true};
  if (end_torque < -std::clamp(2 * line.torque + slope * end_speed, 0.0, line.torque))
    return {.pull = -2 * line.torque,
            .damping = slope,
            .low = std::clamp(wanted, -line.torque, 0.0),
            .high = 0,
            .ends_line = true};
  return by_law;
}

// A cable that is wound up to `winch.position`; slack: nothing.
inline soft_force cable_force(motor_line line,
                              const robots::cable_drive& cable,
                              const cable_winch& winch,
                              double q) {
  const double stretch = winch.position - q;
  if (!(stretch > 0)) return {.low = 0, .high = 0};
  return {.pull = cable.stiffness * stretch + cable.damping * winch.speed,
          .stiffness = cable.stiffness,
          .damping = cable.damping,
          .low = 0,
          .high = line.torque};
}

}  // namespace cca::sim
