// The twin of a robot on virtual drives: it has the robot's graph, and buses that are connected to nothing.
#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <cca/cca.hpp>
#include <cca/hardware/robot/robot.hpp>
#include <cca/hardware/virtual_hardware.hpp>
#include <cca/record/twin.hpp>
#include <cca/robot/limiter.hpp>

#include "../robot_on_drives/pendulum.hpp"

namespace {

namespace robots = cca::robots;
using namespace pendulum_test;

struct pendulum {
  using body = pendulum_body;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  static constexpr std::array drives{robots::joint_drive{.motor = {3, 16}, .stiffness = 20, .damping = 0.6}};
};
using torque = robots::commanded<pendulum, robots::torque_command>;

struct damping {
  double value = 0.1;
  static constexpr auto cca_parameters =
      cca::parameters(cca::parameter<"value">(&damping::value, cca::range{0, 1}));
};
struct damper {
  using parameters = damping;
  auto process(cca::in<"angle", robots::angles<pendulum>> angle) -> cca::out<"torque", torque> {
    return -p.value * angle.vector()[0];
  }
  damping p{};
};

template <class Bus>
struct on_drive : hw::robot<pendulum, Bus, swing_joint> {};
template <class Bus>
struct architecture : cca::graph<cca::rate<1000>,
                                 cca::node<"damper", damper>,
                                 cca::node<"limits", cca::unlimited<torque>>,
                                 cca::node<"robot", on_drive<Bus>>,
                                 cca::wire<"robot.angles", "damper.angle">,
                                 cca::wire<"damper.torque", "limits.command">,
                                 cca::wire<"limits.safe", "robot.torque">> {};

}  // namespace
