// The servo of one joint, simulated or real: from the commands of a beat (commands.hpp) to the law that its
// drive follows.
//
// Position: stiffness and damping towards the target, whose speed is the commanded velocity, or else the
// change of the target, at most the fastest that the joint can move. Velocity without position: the target
// moves at that speed from where the joint was; it runs ahead of the joint by no more than the motor's torque
// can pull. The target of a continuous axis is the nearest one that means the same. Torque is added. Torque
// alone: nothing else acts. A commanded damping also brakes without a
// target. One that `holds` takes the angle of its first beat for its position until a command comes.
// `has_command`: some command has come, or it holds. Cost: some operations.
#pragma once

#include <algorithm>
#include <cmath>

#include <cca/robots/commands.hpp>
#include <cca/robots/joint_law.hpp>
#include <cca/space/methods/circle.hpp>

namespace cca::robots {

// What a servo does with a target, and what its joint can do.
struct servo_numbers {
  double stiffness = 0, damping = 0;  // N m/rad, N m s/rad
  double torque = 0, speed = 0;       // N m, rad/s, at most
  bool continuous = false;            // the axis turns without end
  bool holds = false;
};

class joint_servo {
public:
  joint_law follow(const joint_commands& now, const servo_numbers& servo, double angle, double beat) {
    using enum command_kind;
    for (const auto kind : {position, velocity, torque, stiffness, damping})
      if (std::isfinite(now[kind])) last_[kind] = now[kind];
      else if (kind == torque && std::isfinite(last_[torque])) last_[torque] = 0;

    if (servo.holds && !has_command()) last_[position] = angle;
    joint_law law;
    if (std::isfinite(last_[torque])) law.torque = last_[torque];
    const bool to_position = std::isfinite(last_[position]), at_speed = std::isfinite(last_[velocity]);
    if (std::isfinite(last_[damping])) law.damping = last_[damping];
    if (!to_position && !at_speed) return law;

    law.stiffness = std::isfinite(last_[stiffness]) ? last_[stiffness] : servo.stiffness;
    if (!std::isfinite(last_[damping]))
      law.damping = servo.stiffness > 0 ? servo.damping * law.stiffness / servo.stiffness : servo.damping;
    const double wanted = servo.continuous ? cca::detail::same_turn(last_[position], angle) : last_[position];
    if (!begun_) target_ = to_position ? wanted : angle;
    begun_ = true;
    if (at_speed) law.velocity = last_[velocity];
    else law.velocity = std::clamp((wanted - target_) / beat, -servo.speed, servo.speed);
    if (to_position) {
      target_ = wanted;
    } else {
      const double lead =
          law.stiffness > 0 ? servo.torque / law.stiffness : 0;  // without stiffness only damping acts
      target_ = std::clamp(target_ + law.velocity * beat, angle - lead, angle + lead);
    }
    law.position = target_;
    return law;
  }

  bool has_command() const {
    return std::ranges::any_of(last_.values, [](double number) { return std::isfinite(number); });
  }

private:
  joint_commands last_{};
  double target_ = 0;
  bool begun_ = false;
};

}  // namespace cca::robots
