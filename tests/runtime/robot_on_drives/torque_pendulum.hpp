#pragma once
// The description of the pendulum, commanded by torques alone.
#include <array>

#include <cca/hardware/robot/robot.hpp>

#include "pendulum.hpp"

namespace pendulum_test {

namespace robots = cca::robots;

struct pendulum {
  using body = pendulum_body;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  static constexpr std::array drives{robots::joint_drive{.motor = {3, 16}, .stiffness = 20, .damping = 0.6}};
};
using torque = robots::commanded<pendulum, robots::torque_command>;

}  // namespace pendulum_test
