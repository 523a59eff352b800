// A robot on virtual drives, as docs/hardware.md shows it: put at an angle, run, disturbed by axis.
#include <array>
#include <cmath>
#include <tuple>

#include <doctest/doctest.h>

#include "pendulum.hpp"

// [includes]
#include <cca/cca.hpp>
#include <cca/hardware/cia402.hpp>
#include <cca/hardware/robot/robot.hpp>
#include <cca/hardware/virtual_hardware.hpp>
#include <cca/robot/limiter.hpp>

namespace hw = cca::hardware;
namespace robots = cca::robots;
// [includes end]

namespace {

using pendulum_test::pendulum_body, pendulum_test::swing, pendulum_test::swing_joint;

// [robot]
struct pendulum {
  using body = pendulum_body;  // one joint, of the axis `swing`
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::position_command>;
  static constexpr std::array drives{robots::joint_drive{.stiffness = 20, .damping = 0.6}};
};
struct on_drive : hw::robot<pendulum, hw::virtual_bus_end, swing_joint> {};

struct to_and_fro {
  auto process(cca::beat now) -> cca::out<"angle", robots::commanded<pendulum, robots::position_command>> {
    return 0.5 * std::cos(2e-9 * static_cast<double>(now.time()));
  }
};
struct swinging
    : cca::graph<cca::node<"to_and_fro", to_and_fro>,
                 cca::node<"limits", cca::limiter<robots::commanded<pendulum, robots::position_command>>>,
                 cca::node<"robot", on_drive>,
                 cca::wire<"to_and_fro.angle", "limits.command">,
                 cca::wire<"limits.safe", "robot.position">> {};
// [robot end]

// [laboratory]
struct laboratory {
  laboratory() {
    far.plant.motor<swing>().inertia = 0.02;  // kg m^2; also friction and most_torque
    far.plant.put_at<swing>(0.5);             // rad, before the start
    controller.load();
  }
  void run(double seconds) {
    for (int k = 0; k < 1000 * seconds; ++k) controller.step(), far.step();
  }

  cca::controller<swinging> controller{};  // its robot is the node "robot"
  hw::virtual_hardware<on_drive, hw::virtual_motors<on_drive::joints>> far{
      controller.get<"robot.synchronizer">()};
};
// [laboratory end]

// Two joints, to be told apart; nothing drives them.
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-2, 2}, cca::velocity{-8, 8}, cca::torque{-3, 3}};
};
struct knee_joint : hw::joint<knee,
                              hw::cia402<pendulum_test::geared_motor, 2, hw::cia402_mode::torque>,
                              hw::mounting{.gear = 40},
                              hw::joint_servo{.stiffness = 20, .damping = 0.6, .safe_damping = 0.5}> {};
struct two_joints {
  using joints = hw::joint_list<swing_joint, knee_joint>;
  using board = hw::no_board;
};

}  // namespace

TEST_SUITE("a robot on virtual drives") {
  TEST_CASE("put at an angle it starts there, follows, and stops when its drive falls silent") {
    laboratory lab;
    // [test]
    const auto angle = [&] { return lab.far.plant.motor<swing>().now.position; };
    lab.controller.start();
    lab.run(0.1);
    CHECK(std::abs(angle() - 0.5) < 0.05);
    lab.run(0.9);
    CHECK(std::abs(angle() - 0.5 * std::cos(2.0)) < 0.1);

    lab.far.drive<swing>().go_silent(true);
    lab.run(0.01);
    CHECK(lab.controller.get<"robot.emergency_stop">().first_cause().rule == hw::safety_rule::silent);

    lab.far.drive<swing>().go_silent(false);
    CHECK(hw::shut_down(lab.controller, lab.far.pace()).complete());
    // [test end]
    CHECK(lab.far.enabled_count() == 0);
  }

  TEST_CASE("of two joints each is put, and its drive is found, by its axis") {
    hw::virtual_hardware<two_joints, hw::virtual_motors<two_joints::joints>> far;
    far.plant.put_at<knee>(-0.7);
    far.plant.motor<swing>().now.velocity = 3;
    far.plant.put_at<swing>(0.25);
    CHECK(far.plant.motions()[0].position == 0.25);
    CHECK(far.plant.motions()[0].velocity == 0);  // at rest
    CHECK(far.plant.motions()[1].position == -0.7);
    CHECK(&far.drive<swing>() == &std::get<0>(far.far.drives));
    CHECK(&far.drive<knee>() == &std::get<1>(far.far.drives));
  }
}
