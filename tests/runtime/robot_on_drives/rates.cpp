// Robots on drives at other rates than 1 kHz, and a wheel that turns without end: all on virtual hardware, in
// one line each.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include <doctest/doctest.h>

#include <cca/cca.hpp>
#include <cca/hardware/cia402.hpp>
#include <cca/hardware/mit.hpp>
#include <cca/hardware/moteus.hpp>
#include <cca/hardware/robot/robot.hpp>
#include <cca/hardware/virtual_hardware.hpp>
#include <cca/robot/limiter.hpp>

#include "pendulum.hpp"

namespace {

namespace robots = cca::robots;
namespace hw = cca::hardware;
using pendulum_test::swing;

struct n1 {
  static constexpr std::string_view name = "n1";
  static constexpr double stiffness = 80, damping = 2, torque = 12, timeout = 0.02;
};
template <std::int64_t Data>
struct on_moteus_at : hw::joint<swing,
                                hw::moteus<n1, 1>,
                                hw::mounting{.gear = 2},
                                hw::joint_servo{.stiffness = 20, .damping = 0.6, .safe_damping = 0.5},
                                0,
                                hw::bit_rates{1'000'000, Data}> {};
using on_moteus = on_moteus_at<5'000'000>;
using on_fast_moteus = on_moteus_at<8'000'000>;  // for 4 kHz

template <auto Hz>
struct pendulum {
  using body = pendulum_test::pendulum_body;
  using rate = cca::rate<Hz>;
  using commands = robots::commands<robots::position_command>;
  static constexpr std::array drives{robots::joint_drive{.motor = {3, 16}, .stiffness = 20, .damping = 0.6}};
};
template <auto Hz, class Joint>
struct robot : hw::robot<pendulum<Hz>, hw::virtual_bus_end, Joint> {};

template <class R>
struct source {
  double value = 0.8;
  auto process(cca::beat) -> cca::out<"value", robots::commanded<R, robots::position_command>> {
    return value;
  }
};
template <class Robot, class R = typename Robot::description>
struct architecture
    : cca::graph<typename R::rate,
                 cca::node<"source", source<R>>,
                 cca::node<"limits", cca::unlimited<robots::commanded<R, robots::position_command>>>,
                 cca::node<"robot", Robot>,
                 cca::wire<"source.value", "limits.command">,
                 cca::wire<"limits.safe", "robot.position">> {};

template <class Robot>
struct lab {
  static constexpr double hz = Robot::description::rate::hz;

  lab() {
    hw::virtual_motor& motor = far.plant.template motor<swing>();
    motor.inertia = 0.02, motor.friction = 0.05;
    controller.load();
  }
  int beats_in(double seconds) const { return static_cast<int>(seconds * hz + 0.5); }
  void run(double seconds) {
    for (int n = beats_in(seconds); n > 0; --n) controller.step(), far.step();
  }
  // s until a condition holds, or `most`.
  template <class Condition>
  double until(double most, Condition holds) {
    int k = 0;
    for (; k < beats_in(most) && !holds(); ++k) controller.step(), far.step();
    return k / hz;
  }
  auto& synchronizer() { return controller.template get<"robot.synchronizer">(); }
  auto& stop() { return controller.template get<"robot.emergency_stop">(); }
  double angle() const { return far.plant.template motor<swing>().now.position; }

  cca::controller<architecture<Robot>> controller{};
  hw::virtual_hardware<Robot, hw::virtual_motors<typename Robot::joints>> far{
      controller.template get<"robot.synchronizer">()};
};

// A wheel on a drive whose position wraps after 25 rad.
struct wheel : cca::dimension<"wheel"> {
  static constexpr bool continuous = true;
  static constexpr auto limits =
      cca::limits{cca::velocity{-20, 20}, cca::torque{-5, 5}, cca::stiffness{0, 50}};
};
struct mount : cca::frame<"mount"> {};
struct rim : cca::frame<"rim"> {};
struct axle : cca::serial_chain<mount, rim, cca::axes<wheel>> {
  static constexpr std::array joints{cca::revolute(cca::along_y)};
  static constexpr auto tip = cca::at(0, 0, 0.1);
  [[maybe_unused]] static constexpr std::array links{
      cca::link_inertia{0.5, {0, 0, 0}, {0.001, 0.001, 0.001, 0, 0, 0}}};
};
struct cart_body : cca::body<mount, cca::part<"axle", axle, cca::driven_by<"wheel">>> {};
struct cart {
  using body = cart_body;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::position_command>;
  static constexpr std::array drives{robots::joint_drive{.motor = {5, 30}, .stiffness = 20, .damping = 0.6}};
};
struct on_mit : hw::joint<wheel,
                          hw::mit_drive<hw::ak60_6, 1>,
                          hw::mounting{.sign = -1, .wraps = 25},
                          hw::joint_servo{.stiffness = 20, .damping = 1, .safe_damping = 0.5}> {};
struct rolling : hw::robot<cart, hw::virtual_bus_end, on_mit> {};

// The firmware reports the rest of its position by 25 rad, and takes a command as one of this range.
template <class Drive>
struct wrapping : hw::virtual_mit<Drive> {
  double turns = 0;
  hw::drive_frames answer(hw::drive_motion m) {
    const double reported = std::remainder(m.position, 25.0);
    turns = m.position - reported;
    m.position = reported;
    return hw::virtual_mit<Drive>::answer(m);
  }
  hw::drive_command law(std::int64_t now) {
    hw::drive_command c = hw::virtual_mit<Drive>::law(now);
    c.position += turns;
    return c;
  }
};

template <class Robot>
void starts_moves_and_stops() {
  CAPTURE(Robot::description::rate::hz);
  lab<Robot> l;
  l.controller.start();
  CHECK(l.until(1.1, [&] { return l.synchronizer().phase() == hw::motion_phase::running; }) < 0.3);
  l.run(1.5);
  CHECK(l.angle() == doctest::Approx(0.8).epsilon(0.02));
  CHECK(l.stop().first_cause().rule == hw::safety_rule::none);

  // A silent drive is noticed after three beats, and at least 3 ms.
  l.far.template drive<swing>().go_silent(true);
  const double noticed = l.until(1, [&] { return l.stop().mode() != hw::motion_mode::run; });
  CHECK(noticed <= std::max(5 / l.hz, 0.0055));
  CHECK(noticed >= std::max(2 / l.hz, 0.0025));
  CHECK(l.stop().first_cause().rule == hw::safety_rule::silent);
  l.far.template drive<swing>().go_silent(false);
  // A tripped robot is damped for a second, and then disabled.
  const double off = l.until(3, [&] { return l.synchronizer().phase() == hw::motion_phase::stopped; });
  CHECK(off > 0.9);
  CHECK(off < 1.1);
  CHECK(l.until(1, [&] { return !l.synchronizer().stopping(); }) < 0.1);
  CHECK(l.far.enabled_count() == 0);
  CHECK_FALSE(l.synchronizer().unconfirmed(0));
}

// A drive with gains of its own, which can only hold or let go.
struct by_position : hw::joint<swing,
                               hw::cia402<pendulum_test::geared_motor, 1, hw::cia402_mode::position>,
                               hw::mounting{.gear = 40, .sign = -1, .offset = 0.2},
                               hw::joint_servo{.stiffness = 20, .damping = 0.6, .safe_damping = 0.5}> {};

// Idle beats, as where another environment is late, under a load; then beats again.
template <class Joint>
void goes_on_after_idle_beats(int idle, double most_moved) {
  lab<robot<1000, Joint>> l;
  l.controller.start();
  l.until(1.5, [&] { return l.synchronizer().phase() == hw::motion_phase::running; });
  REQUIRE(l.synchronizer().phase() == hw::motion_phase::running);
  l.run(2);
  l.far.plant.load[0] = -1;
  l.run(0.5);
  const double before = l.angle();
  for (int k = 0; k < idle; ++k) l.synchronizer().on_idle(), l.far.step();
  double moved = std::abs(l.angle() - before), fastest = 0;
  for (int k = 0; k < 500; ++k) {
    l.run(0.001);
    moved = std::max(moved, std::abs(l.angle() - before));
    fastest = std::max(fastest, std::abs(l.far.plant.template motor<swing>().now.velocity));
  }
  CAPTURE(idle);
  CHECK(l.far.enabled_count() == 1);
  CHECK(l.stop().first_cause().rule == hw::safety_rule::none);
  CHECK(moved < most_moved);
  CHECK(fastest < 4);  // it does not snap back
}

}  // namespace

TEST_SUITE("robots on drives at other rates") {
  TEST_CASE("idle beats switch no drive off, and a robot that sagged goes on from where it is") {
    for (const int idle : {1, 3, 30, 1000}) goes_on_after_idle_beats<by_position>(idle, 0.01);
    for (const int idle : {1, 3}) goes_on_after_idle_beats<on_moteus>(idle, 0.02);
    goes_on_after_idle_beats<on_moteus>(3000, 1);
  }

  TEST_CASE("200 Hz to 4 kHz: started, moved, and each time limit is the same time") {
    starts_moves_and_stops<robot<200, on_moteus>>();
    starts_moves_and_stops<robot<500, on_moteus>>();
    starts_moves_and_stops<robot<500, pendulum_test::swing_joint>>();
    starts_moves_and_stops<robot<1000, on_moteus>>();
    starts_moves_and_stops<robot<4000, on_fast_moteus>>();
  }

  TEST_CASE(
      "a wheel turns on and on, on a drive whose position wraps, and a far command goes the short way") {
    cca::controller<architecture<rolling>> c;
    hw::virtual_hardware<rolling, hw::virtual_motors<rolling::joints>, wrapping> far(
        c.get<"robot.synchronizer">());
    hw::virtual_motor& m = far.plant.motor<wheel>();
    m.inertia = 0.02, m.friction = 0.02;
    c.load();
    c.get<"source">().value = 0;
    c.start();
    const auto beats = [&](int n) {
      for (; n > 0; --n) c.step(), far.step();
    };
    beats(300);
    REQUIRE(c.get<"robot.synchronizer">().phase() == hw::motion_phase::running);
    // 10 rad/s for 6 s: 60 rad, over the seam of the drive several times. The command wraps at a turn.
    double worst = 0;
    for (int k = 0; k < 6000; ++k) {
      c.get<"source">().value = std::remainder(0.01 * k, 2 * cca::pi);
      beats(1);
      worst = std::max(worst, std::abs(m.now.position - 0.01 * k));
    }
    CHECK(worst < 0.3);
    CHECK(m.now.position > 59);
    CHECK(c.get<"robot.emergency_stop">().first_cause().rule == hw::safety_rule::none);
    beats(500);
    const double there = m.now.position;
    c.get<"source">().value = there + 2.5 + 8 * cca::pi;  // 2.5 rad ahead
    beats(1500);
    CHECK(m.now.position == doctest::Approx(there + 2.5).epsilon(0.005));
    CHECK(c.get<"robot.emergency_stop">().first_cause().rule == hw::safety_rule::none);
  }
}
