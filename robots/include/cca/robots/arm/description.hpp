// The arm described for the simulator and for drives: `cca::sim::robot<cca::robots::arm::description>`.
//
//   in   "torque", "position", "velocity", "stiffness", "damping"   each optional, over joint_axes
//   out  "angles", "velocities", "torques"; "flange_load"  wrench of the world on the tool, in the flange
//
// The body says which numbers are published. CHOSEN, all of this header: the servos and the friction of the
// joints, the motors' no-load speeds (twice the published velocity limits, so that the full torque is there
// up to them), the shapes (capsules around the links, a sphere as tool), the starting posture.
#pragma once

#include <cca/robots/arm/body.hpp>
#include <cca/robots/description.hpp>
#include <cca/robots/ports.hpp>

namespace cca::robots::arm {

struct description {
  using body = arm::body;
  using rate = cca::rate<1000>;
  using commands = robots::
      commands<torque_command, position_command, velocity_command, stiffness_command, damping_command>;
  using sensors = robots::sensors<force_sensor<"flange_load", "arm">>;

  static constexpr joint_drive large{.motor = {87, 4.35}, .stiffness = 600, .damping = 50, .friction = 0.1};
  static constexpr joint_drive small{.motor = {12, 5.22}, .stiffness = 100, .damping = 2, .friction = 0.05};
  static constexpr std::array<joint_drive, 7> drives{large, large, large, large, small, small, small};

  static constexpr double tool_radius = 0.03;
  static constexpr std::array shapes{on_link("arm", 0, capsule(0.06, 0.283), cca::at(0, 0, -0.1915)),
                                     on_link("arm", 2, capsule(0.06, 0.12), cca::at(0, 0, -0.07)),
                                     on_link("arm", 4, capsule(0.06, 0.1), cca::at(0, 0, -0.26)),
                                     on_link("arm", 5, sphere(0.055), cca::at(0.088, 0, 0)),
                                     at_tip("arm", sphere(tool_radius), cca::at(0, 0, tool_radius))};

  // The flange looks down at 0.3 m in front of the base.
  static constexpr std::array<double, 7> start{
      0, -std::numbers::pi / 4, 0, -3 * std::numbers::pi / 4, 0, std::numbers::pi / 2, std::numbers::pi / 4};
};

using angles = robots::angles<description>;
using velocities = robots::velocities<description>;
using torques = robots::torques<description>;

}  // namespace cca::robots::arm
