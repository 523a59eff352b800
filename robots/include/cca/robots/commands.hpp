// The commands that drives take, each one port of the whole robot and one of each joint.
//
//   command              port        limits of each axis   bounded by the limiter
//   position_command     position    angle                 range; velocity, acceleration, jerk, if stated
//   velocity_command     velocity    velocity              range; acceleration, jerk, if stated
//   torque_command       torque      torque                range; torque_rate, if stated
//   stiffness_command    stiffness   stiffness             range
//   damping_command      damping     damping               range
//
// Each port is optional. What is wired decides what a joint does (law_of):
//
//   torque alone                the motor gives that torque
//   position                    the servo follows it, with the stiffness that is commanded or its own;
//                               velocity, if commanded, is the speed of the target, torque is added
//   velocity without position   the servo's target moves at that speed from where the joint is
//
// Without a commanded damping, a commanded stiffness scales the servo's own. Damping, with a stiffness or
// alone, acts without a position too: it brakes. Until a first command arrives a motor gives nothing.
// Commands that are not finite, which no limiter lets pass: a torque is 0, the others keep
// the last one.
// Errors: robot.unlimited_command, space.missing_limits.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include <cca/base/fixed_string.hpp>
#include <cca/space/domain.hpp>

namespace cca::robots {

enum class command_kind : std::size_t { position, velocity, torque, stiffness, damping };
inline constexpr std::size_t command_kinds = 5;

template <fixed_string Name, class Domain, command_kind Kind>
struct command {
  static constexpr auto name = Name;
  static constexpr auto kind = Kind;
  static constexpr bool is_hint = false;
  using domain = Domain;
};

using position_command = command<"position", joint_angles, command_kind::position>;
using velocity_command = command<"velocity", joint_velocities, command_kind::velocity>;
using torque_command = command<"torque", joint_torques, command_kind::torque>;
using stiffness_command = command<"stiffness", joint_stiffness, command_kind::stiffness>;
using damping_command = command<"damping", joint_damping, command_kind::damping>;

template <class... Commands>
struct commands {};

// The commands of one joint, NaN where none has come yet.
struct joint_commands {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::array<double, command_kinds> values{none, none, none, none, none};

  constexpr double operator[](command_kind kind) const { return values[static_cast<std::size_t>(kind)]; }
  constexpr double& operator[](command_kind kind) { return values[static_cast<std::size_t>(kind)]; }
};

}  // namespace cca::robots
