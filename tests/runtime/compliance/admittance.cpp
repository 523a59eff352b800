// Admittance in the air and against a stiff wall.
#include <cca/robot/compliance/admittance.hpp>

#include "rig.hpp"

using namespace compliance_test;

namespace {

using give = cca::admittance<arm_base, flange>;
using pose7 = Eigen::Matrix<double, 7, 1>;
using wanted_pose = cca::in<"reference", cca::pose_in<arm_base>>;
using felt = cca::in<"wrench", cca::load_on<flange, arm_base>>;
using wanted_damping = cca::optional_in<"damping", cca::damping_at<flange, arm_base>>;

pose7 place() {
  pose7 p;
  p << 0.4, 0.1, 0.5, cca::rotation::exp(Eigen::Vector3d(0.3, -0.2, 0.5));
  return p;
}

auto step(give& one, const vector6& wrench, std::int64_t period = 1'000'000, const pose7& goal = place()) {
  return one.process(given<wanted_pose>(goal), given<felt>(wrench), {0, period, 1}, {}, {}, {});
}

// Against a wall of `stiffness` that begins at the reference, with the end one beat late, from a hard touch:
// the largest force within the last fifth, in N, after `seconds`.
double force_at_wall(give one, double stiffness, double seconds, std::int64_t period) {
  one.on_start();
  one.p.stiffness.setZero();
  one.p.farthest.setConstant(1);
  one.p.fastest.setConstant(1);
  vector6 wrench = vector6::Zero();
  double late = 0, later = 0, most = 0;
  const auto beats = static_cast<int>(seconds * 1e9 / static_cast<double>(period));
  double first = 5;  // N: a push that makes it bounce
  for (int k = 0; k < beats; ++k) {
    wrench[3] = -stiffness * later + (k < 3 ? first : 0);
    const auto [pose, twist, status, cut] = step(one, wrench, period);
    later = late;  // the end follows in the next beat
    if (k > 4 * beats / 5) most = std::max(most, std::abs(wrench[3]));
    late = pose.vector()[0] - place()[0];
  }
  return most;
}

}  // namespace

TEST_SUITE("admittance") {
  TEST_CASE("a constant wrench moves it by wrench over stiffness") {
    give one;
    one.p.stiffness << 20, 20, 20, 200, 300, 400;
    one.p.damping << 4, 4, 4, 150, 150, 150;
    const vector6 wrench = (vector6() << 1, -2, 1.5, 20, -12, 9).finished();
    pose7 pose;
    for (int k = 0; k < 20000; ++k) pose = std::get<0>(step(one, wrench)).vector();
    const Eigen::Vector3d turned =
        cca::detail::turn_from(Eigen::Vector4d(place().tail<4>()), Eigen::Vector4d(pose.tail<4>()));
    for (int i = 0; i < 3; ++i) {
      CHECK(pose[i] - place()[i] == doctest::Approx(wrench[3 + i] / one.p.stiffness[3 + i]).epsilon(1e-6));
      CHECK(turned[i] == doctest::Approx(wrench[i] / 20).epsilon(1e-6));
    }
    CHECK(pose.tail<4>().norm() == doctest::Approx(1).epsilon(1e-12));
  }

  TEST_CASE("it moves like its mass and its damper") {
    give one;
    one.p.mass[5] = 4, one.p.damping[5] = 40, one.p.contact.setZero(), one.p.fastest.setConstant(10);
    one.p.farthest.tail<3>().setConstant(10);
    const vector6 wrench = (vector6() << 0, 0, 0, 0, 0, 20).finished();
    double v = 0;
    for (int k = 0; k < 1000; ++k) {
      v = std::get<1>(step(one, wrench, 100'000)).vector()[5];
      CHECK(v == doctest::Approx(0.5 * (1 - std::exp(-10 * 1e-4 * (k + 1)))).epsilon(1e-3));
    }
  }

  TEST_CASE("it takes from the wrench at least what it stores") {
    laws::source random{std::mt19937_64{9}};
    for (int run = 0; run < 20; ++run) {
      give one;
      for (int i = 0; i < 6; ++i) {
        one.p.mass[i] = random(0.01, 5);
        one.p.damping[i] = random(0, 20);
        one.p.stiffness[i] = random(0, 500);
      }
      one.p.fastest.setConstant(100), one.p.farthest.setConstant(3);
      pose7 before = place();
      double work = 0, least = 0;
      for (int k = 0; k < 1000; ++k) {
        vector6 wrench = vector6::Zero();
        for (int i = 3; i < 6; ++i) wrench[i] = 10 * std::sin(0.01 * k * i + run) + random(-5, 5);
        const auto [pose, twist, status, cut] = step(one, wrench);
        work += wrench.tail<3>().dot((pose.vector() - before).head<3>());
        before = pose.vector();
        double stored = 0;
        for (int i = 3; i < 6; ++i) {
          const double away = before[i - 3] - place()[i - 3];
          stored += 0.5 * one.p.mass[i] * twist.vector()[i] * twist.vector()[i] +
                    0.5 * one.p.stiffness[i] * away * away;
        }
        least = std::min(least, work - stored);
      }
      CHECK(least > -1e-9);
    }
  }

  TEST_CASE("with the damping of its bound it rests at a stiff wall - with half of it, it chatters") {
    for (const std::int64_t period : {1'000'000, 10'000'000}) {
      give one;
      one.p.mass.setConstant(0.5);
      const double stiffness = 5000, bound = stiffness * 1e-9 * static_cast<double>(period);
      one.p.contact.setConstant(stiffness);
      one.p.damping.setConstant(bound);
      CHECK(one.p.check_at(1e-9 * static_cast<double>(period)).empty());
      one.p.damping.setConstant(1.05 * bound);
      const double calm = force_at_wall(one, stiffness, 20, period);
      one.p.damping.setConstant(0.5 * bound);
      const double wild = force_at_wall(one, stiffness, 20, period);
      MESSAGE("force at the end: " << calm << " N with 1.05 of the bound, " << wild << " N with half of it");
      CHECK(calm < 1);
      CHECK(wild > 20);
    }
  }

  TEST_CASE("speed and displacement have limits, and say so") {
    give one;
    one.p.fastest.tail<3>().setConstant(0.1), one.p.farthest.tail<3>().setConstant(0.02);
    one.p.fastest.head<3>().setConstant(0.5), one.p.farthest.head<3>().setConstant(0.3);
    const vector6 wrench = (vector6() << 3, 0, 0, 50, 0, 0).finished();
    CHECK(is(std::get<3>(step(one, vector6(0.01 * wrench))), cca::saturation::none));
    double fastest = 0;
    pose7 pose;
    for (int k = 0; k < 3000; ++k) {
      const auto all = step(one, wrench);
      fastest = std::max(fastest, std::get<1>(all).vector()[3]);
      pose = std::get<0>(all).vector();
    }
    const auto last = step(one, wrench);
    CHECK(is(std::get<3>(last), cca::saturation::motion));
    CHECK(one.summary().ends_with(" times the motion was at `fastest` or `farthest`"));
    CHECK(std::get<1>(last).vector().norm() == 0);
    CHECK(fastest == doctest::Approx(0.1));
    CHECK(pose[0] - place()[0] == doctest::Approx(0.02));
    CHECK(cca::detail::turn_from(Eigen::Vector4d(place().tail<4>()), Eigen::Vector4d(pose.tail<4>()))[0] ==
          doctest::Approx(0.3));
  }

  TEST_CASE("the bound of the damping is checked on load and named, and a port is raised to it") {
    give one;
    CHECK_NOTHROW(cca::check_parameters(one.p, "give", 1e-3));
    one.p.lag = 0.02;
    CHECK_THROWS_WITH_AS(
        cca::check_parameters(one.p, "give", 0.1),
        "give: `damping` is 2, but at 10 Hz it must be at least 2.4: run the node faster, or "
        "change it",
        cca::refused);
    const vector6 wrench = (vector6() << 0, 0, 0, 1, 0, 0).finished(), weak = vector6::Zero();
    give by_port = one, by_parameter = one;
    by_parameter.p.damping = by_parameter.p.least_damping(0.1);
    for (int k = 0; k < 5; ++k) {
      const auto a = by_port.process(given<wanted_pose>(place()), given<felt>(wrench), {0, 100'000'000, 1},
                                     {}, {}, given<wanted_damping>(weak));
      const auto b = step(by_parameter, wrench, 100'000'000);
      CHECK(std::get<0>(a).vector() == std::get<0>(b).vector());
      CHECK(is(std::get<2>(a), cca::input_status::clamped));
    }
  }

  TEST_CASE("it stands still while it can't read, and begins at the first reference") {
    give one;
    const vector6 push = (vector6() << 0, 0, 0, 10, 0, 0).finished();
    const auto early = one.process({}, given<felt>(push), {0, 1'000'000, 1}, {}, {}, {});
    CHECK(std::get<0>(early).vector()[6] == 1);
    CHECK(std::get<1>(early).vector().norm() == 0);
    pose7 there;
    for (int k = 0; k < 100; ++k) there = std::get<0>(step(one, push)).vector();
    const auto blind = step(one, vector6::Constant(no_number));
    CHECK(std::get<0>(blind).vector() == there);
    CHECK(std::get<1>(blind).vector().norm() == 0);
    CHECK(is(std::get<2>(blind), cca::input_status::unreadable));
  }
}
