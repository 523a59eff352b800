// The drive of one joint: from the commands of a beat (cca/robots/commands.hpp) to the law that it follows.
//
// Position: stiffness and damping towards the target, whose speed is the commanded velocity, or else the
// change of the target, at most the motor's no-load speed. Velocity without position: the target moves at
// that speed from where the joint was; it runs ahead of the joint by no more than the motor's torque can
// pull. Torque is added. Torque alone: nothing else acts. A commanded damping also brakes without a target.
// `damped` is the law after a fault: the servo's own damping, and nothing else.
#pragma once

#include <algorithm>
#include <cmath>

#include <cca/robots/commands.hpp>
#include <cca/robots/description.hpp>
#include <cca/sim/robot/joint_law.hpp>

namespace cca::sim {

class joint_servo {
public:
  joint_law follow(const robots::joint_commands& now,
                   const robots::joint_drive& drive,
                   double angle,
                   double beat) {
    using enum robots::command_kind;
    for (const auto kind : {position, velocity, torque, stiffness, damping})
      if (std::isfinite(now[kind])) last_[kind] = now[kind];
      else if (kind == torque && std::isfinite(last_[torque])) last_[torque] = 0;

    joint_law law;
    if (std::isfinite(last_[torque])) law.torque = last_[torque];
    const bool to_position = std::isfinite(last_[position]), at_speed = std::isfinite(last_[velocity]);
    if (std::isfinite(last_[damping])) law.damping = last_[damping];
    if (!to_position && !at_speed) return law;

    law.stiffness = std::isfinite(last_[stiffness]) ? last_[stiffness] : drive.stiffness;
    if (!std::isfinite(last_[damping]))
      law.damping = drive.stiffness > 0 ? drive.damping * law.stiffness / drive.stiffness : drive.damping;
    if (!begun_) target_ = to_position ? last_[position] : angle;
    begun_ = true;
    if (at_speed) law.velocity = last_[velocity];
    else
      law.velocity = std::clamp((last_[position] - target_) / beat, -drive.motor.no_load_speed,
                                drive.motor.no_load_speed);
    if (to_position) {
      target_ = last_[position];
    } else {
      const double lead =
          law.stiffness > 0 ? drive.motor.torque / law.stiffness : 0;  // without stiffness only damping acts
      target_ = std::clamp(target_ + law.velocity * beat, angle - lead, angle + lead);
    }
    law.position = target_;
    return law;
  }

  static joint_law damped(const robots::joint_drive& drive) { return {.damping = drive.damping}; }

private:
  robots::joint_commands last_{};
  double target_ = 0;
  bool begun_ = false;
};

}  // namespace cca::sim
