// The smallest described robot on a drive: a pendulum on one CiA 402 drive in torque mode, a plain motor as
// its mechanics.
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/hardware/robot/robot.hpp>
#include <cca/hardware/virtual_hardware.hpp>
#include <cca/robot/limiter.hpp>

#include "pendulum.hpp"

namespace {

namespace robots = cca::robots;

using namespace pendulum_test;

struct pendulum {
  using body = pendulum_body;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command,
                                    robots::position_command,
                                    robots::velocity_command,
                                    robots::stiffness_command,
                                    robots::damping_command>;
  static constexpr std::array drives{robots::joint_drive{.motor = {3, 16}, .stiffness = 20, .damping = 0.6}};
};

struct on_drive : hw::robot<pendulum, end_of_wire, swing_joint> {};

// The same where the drive holds its joint until a command comes.
struct holding : pendulum {
  static constexpr std::array drives{
      robots::joint_drive{.motor = {3, 16}, .stiffness = 20, .damping = 0.6, .holds = true}};
};
struct holds_on_drive : hw::robot<holding, end_of_wire, swing_joint> {};
struct holding_alone : cca::graph<cca::node<"robot", holds_on_drive>> {};

// Commands of one kind: none until there is a value.
template <class Command>
struct source {
  std::optional<double> value;
  auto process(cca::beat) -> cca::maybe<"value", robots::commanded<pendulum, Command>> {
    if (value) return *value;
    return {};
  }
};
// No limiter: the guards of the robot are what is tested.
template <class Command>
using passed = cca::unlimited<robots::commanded<pendulum, Command>>;

struct architecture : cca::graph<cca::rate<1000>,
                                 cca::node<"torque", source<robots::torque_command>>,
                                 cca::node<"position", source<robots::position_command>>,
                                 cca::node<"velocity", source<robots::velocity_command>>,
                                 cca::node<"stiffness", source<robots::stiffness_command>>,
                                 cca::node<"damping", source<robots::damping_command>>,
                                 cca::node<"torques", passed<robots::torque_command>>,
                                 cca::node<"positions", passed<robots::position_command>>,
                                 cca::node<"velocities", passed<robots::velocity_command>>,
                                 cca::node<"stiffnesses", passed<robots::stiffness_command>>,
                                 cca::node<"dampings", passed<robots::damping_command>>,
                                 cca::node<"robot", on_drive>,
                                 cca::wire<"torque.value", "torques.command">,
                                 cca::wire<"position.value", "positions.command">,
                                 cca::wire<"velocity.value", "velocities.command">,
                                 cca::wire<"stiffness.value", "stiffnesses.command">,
                                 cca::wire<"damping.value", "dampings.command">,
                                 cca::wire<"torques.safe", "robot.torque">,
                                 cca::wire<"positions.safe", "robot.position">,
                                 cca::wire<"velocities.safe", "robot.velocity">,
                                 cca::wire<"stiffnesses.safe", "robot.stiffness">,
                                 cca::wire<"dampings.safe", "robot.damping">> {};
static_assert(cca::well_formed<architecture>);

struct reckless : cca::graph<cca::node<"torque", source<robots::torque_command>>,
                             cca::node<"robot", on_drive>,
                             cca::wire<"torque.value", "robot.torque">> {};
static_assert(cca::diagnosis<reckless>.rule == "robot.unlimited_command");

// What a drive with gains of its own follows, and one without.
using positioned = hw::cia402<geared_motor, 1, hw::cia402_mode::position>;
static_assert(hw::detail::follows<positioned>(robots::command_kind::position) &&
              !hw::detail::follows<positioned>(robots::command_kind::torque) &&
              !hw::detail::follows<positioned>(robots::command_kind::stiffness) &&
              hw::detail::follows<swing_joint::drive>(robots::command_kind::damping));

struct lab {
  explicit lab(double at = 0.3) {
    far.plant.put_at<swing>(at);
    motor.inertia = 0.02, motor.friction = 0.01, motor.most_torque = 5;
    controller.load();
  }

  void beats(int n) {
    for (; n > 0; --n) {
      controller.step();
      far.step([this](std::size_t, const hw::can_frame& f) {
        std::uint16_t word = 0;
        hw::drive_command c;
        if (!swing_joint::drive::hear(f, word, c)) return;
        most_sent = std::max(most_sent, std::abs(swing_joint::from_drive(c).torque));
      });
    }
  }
  auto& stop() { return controller.get<"robot.emergency_stop">(); }
  auto& synchronizer() { return controller.get<"robot.synchronizer">(); }
  auto& drive() { return far.drive<swing>(); }
  void run() {
    controller.start();
    beats(60);
    REQUIRE(synchronizer().phase() == hw::motion_phase::running);
  }

  cca::controller<architecture> controller{};
  hw::virtual_hardware<on_drive, hw::virtual_motors<on_drive::joints>> far{
      controller.get<"robot.synchronizer">()};
  hw::virtual_motor& motor = far.plant.motor<swing>();
  hw::drive_command& law = far.laws[0];
  double& load = far.plant.load[0];
  double most_sent = 0;
};

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();
constexpr double least =
    40 * geared_motor::torque / 1000;  // N m at the joint: a thousandth of the rated torque

}  // namespace

TEST_SUITE("a described robot on one drive") {
  TEST_CASE("a torque reaches the joint, with the gear and the sign of its mounting") {
    lab l;
    l.controller.get<"torque">().value = 0;
    l.run();
    l.load = -0.5;
    l.controller.get<"torque">().value = 0.5;
    l.beats(20);
    CHECK(l.law.torque == doctest::Approx(0.5).epsilon(least));
    CHECK(l.law.stiffness == 0);
    CHECK(l.synchronizer().report(0).torque == doctest::Approx(-0.5 / 40).epsilon(0.01));
  }

  TEST_CASE(
      "a torque changes by at most the rate of its axis, and never exceeds its limit, whatever is "
      "commanded") {
    lab l;
    auto& torque = l.controller.get<"torque">().value;
    torque = 0;
    l.run();
    double before = 0;
    for (int k = 0; k < 400; ++k) {
      torque = k / 10 % 2 == 0 ? 1e300 : -40.0;  // to and fro, so the joint stays within range and speed
      l.beats(1);
      CHECK(std::abs(l.law.torque - before) <= 0.6 + 2 * least);
      before = l.law.torque;
    }
    CHECK(l.most_sent <= 3 + least / 2);
    CHECK(l.most_sent > 2.9);
    CHECK(l.stop().mode() == hw::motion_mode::run);
  }

  TEST_CASE(
      "a torque that is not a number stops the joint softly: it is damped at once, and the drive never gets "
      "it") {
    for (const double bad : {not_a_number, infinity, -infinity}) {
      lab l;
      auto& torque = l.controller.get<"torque">().value;
      torque = 0.4;
      l.run();
      torque = bad;
      l.beats(3);
      CHECK(l.stop().mode() == hw::motion_mode::soft);
      CHECK(l.stop().first_cause().rule == hw::safety_rule::not_finite);
      CHECK(l.stop().first_cause().joint == 0);
      l.beats(2000);
      CHECK_FALSE(l.drive().enabled());
      CHECK_FALSE(l.synchronizer().unconfirmed(0));
      CHECK(std::isfinite(l.most_sent));
    }
  }

  TEST_CASE("without a command the joint is only damped") {
    lab l;
    l.run();
    l.load = 1;
    l.beats(500);
    CHECK(l.motor.now.velocity == doctest::Approx(1 / (0.5 + 0.01)).epsilon(0.05));
    CHECK(l.stop().mode() == hw::motion_mode::run);
  }

  TEST_CASE("one whose drive holds stays where motion began, in each start anew") {
    cca::controller<holding_alone> c;
    c.load();
    hw::virtual_hardware<holds_on_drive, hw::virtual_motors<holds_on_drive::joints>> far{
        c.get<"robot.synchronizer">()};
    hw::virtual_motor& motor = far.plant.motor<swing>();
    motor.inertia = 0.02, motor.friction = 0.01, motor.most_torque = 5;
    for (const double at : {0.3, -0.4}) {
      far.plant.put_at<swing>(at);
      far.plant.load[0] = 0;
      c.start();
      for (int k = 0; k < 100; ++k) c.step(), far.step();
      REQUIRE(c.get<"robot.synchronizer">().phase() == hw::motion_phase::running);
      far.plant.load[0] = 1;
      for (int k = 0; k < 1000; ++k) c.step(), far.step();
      CHECK(motor.now.position == doctest::Approx(at + 1 / 20.0).epsilon(0.02));
      c.stop();
      for (int k = 0; k < 2000; ++k) c.step(), far.step();
    }
  }

  TEST_CASE("position, velocity, stiffness and damping: the synchronizer makes the law of a servo") {
    lab l;
    l.controller.get<"position">().value = 0.8;
    l.run();
    l.beats(1500);
    CHECK(l.motor.now.position == doctest::Approx(0.8).epsilon(0.01));
    l.load = 1;
    l.beats(1000);
    CHECK(l.motor.now.position == doctest::Approx(0.8 + 1 / 20.0).epsilon(0.01));  // its own stiffness
    l.controller.get<"stiffness">().value = 40;
    l.controller.get<"damping">().value = 1;
    l.beats(1000);
    CHECK(l.motor.now.position == doctest::Approx(0.8 + 1 / 40.0).epsilon(0.01));
    l.controller.get<"torque">().value = -1;
    l.beats(1000);
    CHECK(l.motor.now.position == doctest::Approx(0.8).epsilon(0.01));

    lab at_speed(-1);
    at_speed.controller.get<"velocity">().value = 0.5;
    at_speed.run();
    at_speed.beats(500);
    CHECK(at_speed.motor.now.velocity == doctest::Approx(0.5).epsilon(0.02));
    const double before = at_speed.motor.now.position;
    at_speed.beats(1000);
    CHECK(at_speed.motor.now.position - before == doctest::Approx(0.5).epsilon(0.02));
  }

  TEST_CASE("stopped, a torque drive is damped by the velocity that it reports, and then disabled") {
    lab l;
    l.controller.get<"torque">().value = 0;
    l.run();
    l.load = 1;
    l.beats(50);
    l.controller.stop();
    l.beats(100);
    const double falling = l.motor.now.velocity;
    CHECK(l.law.torque == doctest::Approx(-0.5 * falling).epsilon(0.1));
    l.beats(300);
    CHECK(l.motor.now.velocity == doctest::Approx(1 / (0.5 + 0.01)).epsilon(0.05));
    CHECK(l.drive().enabled());
    l.load = 0;
    l.beats(700);
    CHECK_FALSE(l.drive().enabled());
    CHECK_FALSE(l.synchronizer().stopping());
    CHECK_FALSE(l.synchronizer().unconfirmed(0));
  }

  TEST_CASE("a velocity of the wrong sign would drive instead of damp: then the drive is disabled") {
    lab l;
    l.controller.get<"torque">().value = 0;
    l.run();
    l.load = 1;
    l.far.speed_scale[0] = -1;
    for (int k = 0; k < 300 && l.stop().mode() == hw::motion_mode::run; ++k) l.beats(1);
    CHECK(l.stop().first_cause().rule == hw::safety_rule::implausible);
    l.beats(3);
    CHECK_FALSE(l.drive().enabled());
    CHECK(l.law.torque == 0);
  }
}
