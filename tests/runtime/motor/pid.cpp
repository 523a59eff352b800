// PID against closed forms of step responses; saturation; bumpless transfers.
#include <cca/motor/pid.hpp>
#include <vector>

#include "rig.hpp"

using namespace motor_test;

namespace {

struct torques : cca::space<cca::joint_torques, cca::axes<hip, knee>> {};
struct elbow : cca::dimension<"elbow"> {
  static constexpr auto limits = cca::limits{cca::angle{-3, 3}, cca::torque{-1, 2}};
};
struct elbow_angle : cca::space<cca::joint_angles, cca::axes<elbow>> {};
struct elbow_torque : cca::space<cca::joint_torques, cca::axes<elbow>> {};
using number = Eigen::Matrix<double, 1, 1>;

template <class P, class M, class C>
double command(
    P& pid, double reference, double measured, double manual = 0, std::optional<double> automatic = {}) {
  using manual_port = cca::optional_in<"manual", C>;
  using automatic_port = cca::optional_in<"automatic", cca::over<cca::status, cca::automatic_axis>>;
  return std::get<0>(pid.process(cca::in<"reference", M>(number(reference), 0, true),
                                 cca::in<"measured", M>(number(measured), 0, true),
                                 automatic ? wired<manual_port>(number(manual)) : manual_port{},
                                 automatic ? wired<automatic_port>(number(*automatic)) : automatic_port{},
                                 at(0)))
      .vector()[0];
}

struct free_axis : cca::dimension<"free"> {};
struct plant_y : cca::space<cca::number, cca::axes<free_axis>> {};
using servo = cca::pid<plant_y, plant_y>;
double u_of(servo& pid, double r, double y) { return command<servo, plant_y, plant_y>(pid, r, y); }

servo gains(double kp, double ki, double kd, double filter = 1e-4) {
  servo pid;
  pid.p.proportional[0] = kp, pid.p.integral[0] = ki, pid.p.derivative[0] = kd, pid.p.filter = filter;
  return pid;
}

using limited = cca::pid<elbow_angle, elbow_torque>;
double u_of(limited& pid, double r, double y, double manual = 0, std::optional<double> automatic = {}) {
  return command<limited, elbow_angle, elbow_torque>(pid, r, y, manual, automatic);
}

// The step response of y' = u from 0 to reference 1, with beats of 1 ms.
template <class Pid>
std::vector<double> response(Pid& pid, int beats, double load = 0) {
  std::vector<double> all;
  double y = 0;
  for (int k = 0; k < beats; ++k) all.push_back(y += 1e-3 * (u_of(pid, 1, y) - load));
  return all;
}

}  // namespace

TEST_CASE("P and PI on an integrator follow the closed forms of their step responses") {
  auto p = gains(4, 0, 0);
  const auto proportional = response(p, 2000);
  auto pi = gains(8, 16, 0);  // critically damped, l = 4: y = 1 - e^(-l t) (1 - l t)
  const auto both = response(pi, 2000);
  for (int k : {50, 200, 500, 1500}) {
    const double t = 1e-3 * (k + 1);
    CHECK(std::abs(proportional[static_cast<std::size_t>(k)] - (1 - std::exp(-4 * t))) < 2e-3);
    CHECK(std::abs(both[static_cast<std::size_t>(k)] - (1 - std::exp(-4 * t) * (1 - 4 * t))) < 5e-3);
  }
}

TEST_CASE("PD on a double integrator is a critically damped spring: the derivative is on the measurement") {
  auto pid = gains(25, 0, 10, 1e-5);
  double y = 0, v = 0;
  for (int k = 0; k < 2000; ++k) {
    const double u = u_of(pid, 1, y);
    y += 1e-3 * v + 0.5e-6 * u, v += 1e-3 * u;
    const double lt = 5e-3 * (k + 1);
    CHECK(std::abs(y - (1 - (1 + lt) * std::exp(-lt))) < 4e-3);
  }
}

TEST_CASE("a step of the reference makes no kick, but one of the measurement makes a filtered one") {
  auto pid = gains(2, 0, 5, 0.05);
  CHECK(u_of(pid, 0, 0) == 0);
  CHECK(u_of(pid, 1, 0) == doctest::Approx(2));
  auto other = gains(0, 0, 5, 0.05);
  CHECK(u_of(other, 0, 0) == 0);
  double filtered = 0;
  for (int k = 0; k < 200;
       ++k) {  // D = -kd / (filter + dt) (y - y_f), which decays by filter / (filter + dt) a beat
    CHECK(u_of(other, 0, 1) == doctest::Approx(-5 / 0.051 * (1 - filtered)));
    filtered += (1 - filtered) / 51;
  }
  auto begun = gains(0, 0, 5, 0.05);
  CHECK(u_of(begun, 3, 3) == 0);  // the first measurement makes no kick either
}

TEST_CASE("the integral compensates a constant load, P alone does not") {
  auto pi = gains(8, 16, 0);
  CHECK(response(pi, 6000, 0.5).back() == doctest::Approx(1).epsilon(1e-4));
  auto p = gains(8, 0, 0);
  CHECK(response(p, 6000, 0.5).back() == doctest::Approx(1 - 0.5 / 8).epsilon(1e-4));
}

TEST_CASE("the command stays within the limits of its axes and largest") {
  limited pid;
  pid.p.proportional[0] = 10;
  CHECK(u_of(pid, 3, 0) == 2);
  CHECK(u_of(pid, -3, 0) == -1);
  pid.p.largest[0] = 0.5;
  CHECK(u_of(pid, 3, 0) == 0.5);
  CHECK(u_of(pid, -3, 0) == -0.5);
}

TEST_CASE(
    "back-calculation: after a long saturation the command leaves the limit at once, and the overshoot is "
    "small") {
  const auto overshoot = [](double tracking) {
    limited pid;
    pid.p.proportional[0] = 4, pid.p.integral[0] = 8, pid.p.tracking = tracking;
    double y = -20, most = -20;  // a long way at a speed of at most 2
    for (int k = 0; k < 25'000; ++k) y += 1e-3 * u_of(pid, 0, y), most = std::max(most, y);
    if (tracking < 1) CHECK(std::abs(y) < 1e-2);
    return most;
  };
  CHECK(overshoot(0.1) < 0.2);
  CHECK(overshoot(1000) > 2);  // wound up
  // In saturation the integral settles where v = u + ki tracking e: it is bounded.
  limited pid;
  pid.p.proportional[0] = 1, pid.p.integral[0] = 10, pid.p.tracking = 0.1;
  for (int k = 0; k < 100'000; ++k) CHECK(u_of(pid, 3, 0) == 2);
  CHECK(u_of(pid, -3, 0) < 2);
}

TEST_CASE("a tracking time shorter than a beat counts as one beat") {
  limited one, other;
  one.p.proportional[0] = other.p.proportional[0] = 1, one.p.integral[0] = other.p.integral[0] = 10;
  one.p.tracking = 1e-3, other.p.tracking = 1e-5;
  for (int k = 0; k < 500; ++k) {
    const double reference = k < 300 ? 3 : -0.2;
    CHECK(u_of(one, reference, 0) == doctest::Approx(u_of(other, reference, 0)).epsilon(1e-12));
  }
}

TEST_CASE("from manual to automatic without a bump, and back in manual it follows the manual command") {
  limited pid;
  pid.p.proportional[0] = 3, pid.p.integral[0] = 2, pid.p.derivative[0] = 0.1;
  for (int k = 0; k < 100; ++k) CHECK(u_of(pid, 1, 0.2, 0.7, 0.0) == 0.7);
  CHECK(u_of(pid, 1, 0.2, 0.7, 0.0) == 0.7);
  CHECK(u_of(pid, 1, 0.2, 0.7, 1.0) ==
        doctest::Approx(0.7).epsilon(1e-12));  // error 0.8: without bumpless transfer it would jump to 2
  CHECK(u_of(pid, 1, 0.2, 0.7, 1.0) == doctest::Approx(0.7 + 1e-3 * 2 * 0.8).epsilon(1e-9));
  CHECK(u_of(pid, 1, 0.2, 9.0, 0.0) == 2);           // the manual command is limited too
  CHECK(u_of(pid, 1, 0.2, std::nan(""), 0.0) == 0);  // and none if it is not finite
  CHECK(std::isfinite(u_of(pid, 1, 0.2, 0.0, 1.0)));
}

TEST_CASE("a change of gains at run time makes no bump") {
  auto pid = gains(8, 16, 0.5, 0.01);
  double y = 0, last = 0;
  for (int k = 0; k < 300; ++k) y += 1e-3 * (last = u_of(pid, 1, y));
  auto copy = pid;
  pid.p.proportional[0] = 2, pid.p.derivative[0] = 3;
  CHECK(u_of(pid, 1, y) == doctest::Approx(u_of(copy, 1, y)).epsilon(1e-9));
  // Without integral action the difference decays within the tracking time.
  auto p = gains(8, 0, 0);
  CHECK(u_of(p, 1, 0) == 8);
  p.p.proportional[0] = 2;
  CHECK(u_of(p, 1, 0) == doctest::Approx(8));
  for (int k = 0; k < 99; ++k) (void)u_of(p, 1, 0);
  CHECK(u_of(p, 1, 0) == doctest::Approx(2 + 6 * std::pow(0.99, 100)).epsilon(1e-9));
}

TEST_CASE("without a readable number the command is 0, says its status, and the integral is frozen") {
  auto pid = gains(8, 16, 0);
  for (int k = 0; k < 100; ++k) (void)u_of(pid, 1, 0);
  auto untouched = pid;
  const auto status = [&](double r, double y) {
    return std::get<1>(pid.process(cca::in<"reference", plant_y>(number(r), 0, true),
                                   cca::in<"measured", plant_y>(number(y), 0, true), {}, {}, at(0)))
        .vector()[0];
  };
  using enum cca::input_status;
  for (int k = 0; k < 2000; ++k) {  // 2 s: a command that is held would have moved the joint far away
    CHECK(u_of(pid, std::nan(""), 0) == 0);
    CHECK(u_of(pid, 1, std::nan("")) == 0);
    CHECK(u_of(pid, 1, cca::infinity) == 0);
  }
  CHECK(status(1, std::nan("")) == cca::status_of(unreadable));
  CHECK(u_of(pid, 1, 0) == u_of(untouched, 1, 0));
  CHECK(status(1, 0) == cca::status_of(usable));
  CHECK(status(1e300, 0) == cca::status_of(clamped));
}

TEST_CASE("by hand a readable command is followed even without a measurement") {
  limited pid;
  CHECK(u_of(pid, 1, std::nan(""), 0.7, 0.0) == 0.7);
  CHECK(u_of(pid, 1, std::nan(""), std::nan(""), 0.0) == 0);
  CHECK(u_of(pid, 1, std::nan(""), 0.7, 1.0) == 0);
}

TEST_CASE("with the velocity of a movement and its feed-forward a joint follows without being behind") {
  // y'' = u follows r = sin t. PD alone is behind by (kd r' + r'') / kp.
  using velocity = cca::optional_in<"velocity", cca::velocity_of<plant_y>>;
  using feedforward = cca::optional_in<"feedforward", plant_y>;
  const auto worst = [](bool with_velocity, bool with_torque) {
    auto pid = gains(100, 0, 20, 1e-3);
    double y = 0, v = 1, most = 0;
    for (int k = 0; k < 6000; ++k) {
      const double t = 1e-3 * k;
      const double u =
          std::get<0>(pid.process(cca::in<"reference", plant_y>(number(std::sin(t)), 0, true),
                                  cca::in<"measured", plant_y>(number(y), 0, true), {}, {}, at(k),
                                  with_velocity ? wired<velocity>(number(std::cos(t))) : velocity{},
                                  with_torque ? wired<feedforward>(number(-std::sin(t))) : feedforward{}))
              .vector()[0];
      y += 1e-3 * v + 0.5e-6 * u, v += 1e-3 * u;
      if (k > 1000) most = std::max(most, std::abs(std::sin(t + 1e-3) - y));
    }
    return most;
  };
  CHECK(worst(false, false) > 0.15);
  CHECK(worst(true, false) < 0.015);
  CHECK(worst(true, true) < 1e-3);
}

TEST_CASE("negative and huge gains are refused, and nothing allocates") {
  auto pid = gains(8, 16, 0);
  servo::parameters bad = servo{}.p;
  CHECK_NOTHROW(cca::check_parameters(bad));
  bad.integral[0] = -1;
  CHECK_THROWS_AS(cca::check_parameters(bad), cca::refused);
  bad.integral[0] = 1e13;
  CHECK_THROWS_AS(cca::check_parameters(bad), cca::refused);
  const std::size_t counted = laws::allocations();
  for (int k = 0; k < 1000; ++k) (void)u_of(pid, 1, 0);
  CHECK(laws::allocations() == counted);
}
