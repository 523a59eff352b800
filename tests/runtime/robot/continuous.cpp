// Continuous axes: angles that differ by whole turns mean the same, and every difference is the shortest way.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include <cca/cca.hpp>
#include <cca/mapping.hpp>
#include <cca/motor.hpp>
#include <cca/robot.hpp>
#include <cca/robots/joint_servo.hpp>

namespace {

constexpr double turn = 2 * cca::pi;

struct arm_axis : cca::dimension<"arm_axis"> {
  static constexpr auto limits =
      cca::limits{cca::angle{-3.1, 3.1}, cca::velocity{-5, 5}, cca::torque{-100, 100}};
};
// [wheel]
struct wheel : cca::dimension<"wheel"> {
  static constexpr bool continuous = true;
  static constexpr auto limits = cca::limits{cca::velocity{-5, 5}, cca::torque{-100, 100}};
};
// [wheel end]
using both = cca::axes<arm_axis, wheel>;
struct angles : cca::space<cca::joint_angles, both, cca::rate<1000>> {};
struct velocities : cca::space<cca::joint_velocities, both, cca::rate<1000>> {};
struct torques : cca::space<cca::joint_torques, both, cca::rate<1000>> {};
using vector = Eigen::Vector2d;

static_assert(cca::is_continuous<wheel> && !cca::is_continuous<arm_axis>);
static_assert(cca::detail::missing_limits<angles> == -1 && cca::detail::has_continuous_angles<angles> &&
              !cca::detail::has_continuous_angles<velocities>);

// The angle of a continuous axis needs limits of its velocity.
struct free_wheel : cca::dimension<"free_wheel"> {
  static constexpr bool continuous = true;
};
struct free_angle : cca::space<cca::joint_angles, cca::axes<free_wheel>> {};
struct still {
  auto process(cca::beat) -> cca::out<"angle", free_angle> { return 0.1; }
};
struct motor {
  void act(cca::in<"command", free_angle>) {}
};
struct unbounded : cca::graph<cca::rate<1000>,
                              cca::node<"still", still>,
                              cca::node<"limits", cca::limiter<free_angle>>,
                              cca::node<"motor", motor>,
                              cca::wire<"still.angle", "limits.command">,
                              cca::wire<"limits.safe", "motor.command">> {};
static_assert(cca::diagnosis<unbounded>.rule == "space.missing_limits");
static_assert(cca::diagnosis<unbounded>.message.find("`free_wheel` states no limits of velocity to keep") !=
              std::string_view::npos);

struct base : cca::frame<"base"> {};
struct tip : cca::frame<"tip"> {};
struct chain : cca::serial_chain<base, tip, both> {
  static constexpr std::array joints{cca::revolute(cca::along_z),
                                     cca::revolute(cca::along_z, cca::at(0.5, 0, 0))};
  static constexpr auto tip = cca::at(0.4, 0, 0);
  static constexpr std::array links{cca::link_inertia{1, {0.2, 0, 0}, {0.01, 0.01, 0.01, 0, 0, 0}},
                                    cca::link_inertia{1, {0.2, 0, 0}, {0.01, 0.01, 0.01, 0, 0, 0}}};
};
struct body : cca::body<base, cca::part<"arm", chain, cca::driven_by<"arm_axis", "wheel">>> {};
struct at_tip : cca::space<cca::cartesian_position<base>, cca::axes<cca::x, cca::y>> {};

template <cca::fixed_string Name, class Space>
cca::in<Name, Space> now(const typename Space::vector_type& v) {
  return {v, 0, true};
}
constexpr cca::beat first{0, 1'000'000, 1};

}  // namespace

TEST_SUITE("continuous axes") {
  TEST_CASE("differences and interpolation take the short way, of other axes the plain one") {
    const vector from(-3, -3), to(3, 3);
    CHECK(cca::difference_of<angles>(to, from) == vector(6, 6 - turn));
    CHECK(cca::difference_of<velocities>(to, from) == vector(6, 6));
    const vector middle = cca::sample<angles>(from).interpolated(cca::sample<angles>(to), 0.5).vector();
    CHECK(middle[0] == 0);
    CHECK(std::abs(middle[1]) == doctest::Approx(cca::pi));
  }

  TEST_CASE("a PID controller turns the short way, also while the measured angle jumps by a turn") {
    cca::pid<angles, torques> pid;
    pid.p.proportional = vector(2, 2), pid.p.derivative = vector(1, 1);
    const auto command = [&](const vector& wanted, const vector& measured) {
      return std::get<0>(pid.process(now<"reference", angles>(wanted), now<"measured", angles>(measured), {},
                                     {}, first, {}, {}))
          .vector();
    };
    CHECK(command({3, 3}, {-3, -3})[0] == doctest::Approx(12));
    CHECK(command({3, 3}, {-3, -3})[1] == doctest::Approx(2 * (6 - turn)));
    const double before = command({3, 3}, {-3, 3.14})[1], after = command({3, 3}, {-3, -3.14})[1];
    CHECK(std::abs(after - before) < 10);  // 6 rad in a beat would kick by hundreds
  }

  TEST_CASE("joint impedance: the spring pulls the short way") {
    cca::joint_impedance<body, angles, velocities, torques> spring;
    spring.p.compensate_gravity = false;
    spring.p.stiffness = vector(2, 2);
    const auto torque = std::get<0>(spring.process(now<"reference", angles>({3, 3}),
                                                   now<"angles", angles>({-3, -3 + 5 * turn}),
                                                   now<"velocities", velocities>({0, 0}), {}, {}, {}, {}, {}))
                            .vector();
    CHECK(torque[0] == doctest::Approx(12));
    CHECK(torque[1] == doctest::Approx(2 * (6 - turn)));
  }

  TEST_CASE("a limiter goes the short way and never jumps by a turn") {
    cca::limiter<angles> limit;
    std::int64_t k = 0;
    const auto safe = [&](const vector& command) {
      const std::int64_t time = 1'000'000 * k++;
      return limit.process({command, time, true}, {}, cca::beat{k, 1'000'000, 1}).vector();
    };
    safe({3, 3.1});
    for (int i = 0; i < 9; ++i) CHECK(safe({3, -3.1})[1] == doctest::Approx(3.1 + 5e-3 * (i + 1)));
    for (int i = 0; i < 100; ++i) safe({3, -3.1});
    CHECK(safe({3, -3.1})[1] == doctest::Approx(turn - 3.1));
    const std::int64_t before = limit.interventions();
    // Turning on, as a command that wraps and as one that does not.
    double last = safe({3, -3.1})[1];
    for (int i = 1; i < 10'000; ++i) {
      const double wrapped = std::remainder(-3.1 + 4e-3 * i, turn);
      const double next = safe({3, i % 2 == 0 ? wrapped : wrapped + 7 * turn})[1];
      REQUIRE(std::abs(next - last - 4e-3) < 1e-9);
      last = next;
    }
    CHECK(limit.interventions() == before);
    CHECK(last > 6 * turn);
    CHECK(safe({3, std::numeric_limits<double>::quiet_NaN()})[1] == last);
  }

  TEST_CASE("inverse kinematics: the angle nearest to where the search begins, whole turns apart") {
    cca::inverse_kinematics<chain, angles, at_tip> ik;
    const auto tip_of = [](const vector& q) {
      return vector(0.5 * std::cos(q[0]) + 0.4 * std::cos(q[0] + q[1]),
                    0.5 * std::sin(q[0]) + 0.4 * std::sin(q[0] + q[1]));
    };
    for (int i = 0; i < 200; ++i) {
      const vector q(-2 + 0.02 * i, -20 + 0.2 * i), near = q + vector(0.1, 0.1);
      cca::optional_in<"near", angles> start(near, 0, true);
      start.set_wired();
      const auto [found, status] = ik.process(now<"position", at_tip>(tip_of(q)), start);
      const vector there = found.vector();
      CHECK((tip_of(there) - tip_of(q)).norm() < 1e-6);
      CHECK(std::abs(there[1] - near[1]) <= cca::pi + 1e-9);
    }
    // Stretched, the first descent has no direction: other starts, around 0, find the answer.
    cca::optional_in<"near", angles> stretched(vector(0, 10 * turn), 0, true);
    stretched.set_wired();
    for (int beat = 0; beat < 50; ++beat) {
      const auto [found, status] = ik.process(now<"position", at_tip>(vector(0.5, 0)), stretched);
      CHECK(std::abs(found.vector()[1] - 10 * turn) <= cca::pi + 1e-9);
      if (beat == 49) CHECK((tip_of(found.vector()) - vector(0.5, 0)).norm() < 1e-6);
    }
  }

  TEST_CASE("the servo of a joint, simulated or real, goes to the nearest target that means the same") {
    cca::robots::joint_servo servo;
    cca::robots::joint_commands wanted;
    wanted[cca::robots::command_kind::position] = 0.5;
    const cca::robots::servo_numbers numbers{20, 0.5, 10, 8, true};
    const auto law = servo.follow(wanted, numbers, 3 * turn, 1e-3);
    CHECK(law.position == doctest::Approx(3 * turn + 0.5));
    CHECK(servo.follow(wanted, numbers, 3 * turn + 0.4, 1e-3).velocity == doctest::Approx(0));
  }
}
