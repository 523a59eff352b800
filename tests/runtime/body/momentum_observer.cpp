// The momentum observer on a simulated arm.
#include <doctest/doctest.h>

#include <cca/robot/dynamics/forward_dynamics.hpp>
#include <cca/robot/dynamics/mass_matrix.hpp>
#include <cca/robot/dynamics/momentum_observer.hpp>

#include "../../laws/finite_laws.hpp"
#include "../../laws/space_laws.hpp"
#include "bodies.hpp"

using namespace body_test;

namespace {

// The torques in another order than the body's axes.
struct angles : cca::space<cca::joint_angles, arm_axes> {};
struct velocities : cca::space<cca::joint_velocities, arm_axes> {};
struct torques : cca::space<cca::joint_torques, cca::axes<a7, a6, a5, a4, a3, a2, a1>> {};
using observer = cca::momentum_observer<arm, angles, velocities, torques>;
using vector = Eigen::Matrix<double, 7, 1>;

struct simulated {
  vector q = {0.3, 0.5, -0.4, 1.1, 0.6, -0.7, 0.2}, dq = vector::Zero();

  static vector acceleration(const vector& q, const vector& dq, const vector& drive, const vector& wrench) {
    const cca::body_pose<arm> now(q);
    return cca::forward_dynamics(now, dq,
                                 vector(drive + now.jacobian<"arm">().transpose() * wrench.head<6>()));
  }
  // Runge and Kutta's fourth order; the wrench on the tip is constant.
  void step(const vector& drive, const vector& wrench, double dt) {
    const vector a1 = acceleration(q, dq, drive, wrench), v2 = dq + 0.5 * dt * a1,
                 a2 = acceleration(q + 0.5 * dt * dq, v2, drive, wrench), v3 = dq + 0.5 * dt * a2,
                 a3 = acceleration(q + 0.5 * dt * v2, v3, drive, wrench), v4 = dq + dt * a3,
                 a4 = acceleration(q + dt * v3, v4, drive, wrench);
    q += dt / 6 * (dq + 2 * v2 + 2 * v3 + v4);
    dq += dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
};

vector observe(observer& o, const vector& q, const vector& dq, const vector& drive, const cca::beat& now) {
  const auto [external, status] =
      o.process(cca::in<"angles", angles>(q, 0, true), cca::in<"velocities", velocities>(dq, 0, true),
                cca::in<"torques", torques>(vector(drive.reverse()), 0, true), now, {});
  return external.vector().reverse();
}

// The largest error while the arm moves, in N m, after the filter has settled.
double error_in_motion(double bandwidth) {
  constexpr std::int64_t period = 1'000'000;
  observer o;
  o.p.bandwidth = bandwidth;
  simulated arm_of;
  vector wrench = vector::Zero();
  wrench.head<6>() << 0.5, -0.3, 0.2, 6, -4, 8;
  const double dt = 1e-9 * static_cast<double>(period);
  vector drive = vector::Zero();
  double worst = 0;
  for (std::int64_t k = 0; k * period < 600'000'000; ++k) {
    const vector r = observe(o, arm_of.q, arm_of.dq, drive, {k, period, 1});
    const cca::body_pose<arm> now(arm_of.q);
    const vector external = now.jacobian<"arm">().transpose() * wrench.head<6>();
    if (k * period > 500'000'000) worst = std::max(worst, (r - external).norm());
    REQUIRE(std::isfinite(r.sum()));
    drive = cca::gravity_torques(now) -
            cca::mass_matrix(now) * vector(8 * arm_of.dq + 30 * (arm_of.q - simulated{}.q));
    arm_of.step(drive, wrench, dt);
  }
  return worst;
}

struct finite_observer : laws::finite_case<observer> {
  static constexpr int settles_in = 600;  // until the filter has forgotten the gap to the last bit
};

}  // namespace

TEST_SUITE("momentum observer") {
  TEST_CASE("at rest a known torque is found, with the time constant of the bandwidth") {
    observer o;
    o.p.bandwidth = 5;
    const simulated still;
    const vector held = cca::gravity_torques(cca::body_pose<arm>(still.q));
    const vector push{1, -2, 3, 0.5, 0, 4, -1};
    for (int k = 0; k < 1000; ++k) {
      const vector r = observe(o, still.q, vector::Zero(), held - push, {k, 1'000'000, 1});
      const double part = 1 - std::pow(1 + 2 * cca::pi * 5e-3, -k);
      CHECK((r - part * push).norm() < 1e-9);
    }
  }

  TEST_CASE("in motion a push is found, but for the lag of the filter") {
    const double at_20 = error_in_motion(20), at_200 = error_in_motion(200);
    MESSAGE("largest error at 20 Hz: " << at_20 << " N m, at 200 Hz: " << at_200 << " N m");
    CHECK(at_20 < 0.05);
    CHECK(at_200 < 0.2 * at_20);
  }

  TEST_CASE("without a push nothing is found") {
    observer o;
    simulated arm_of;
    arm_of.dq << 0.5, -0.4, 0.3, 0.6, -0.2, 0.1, 0.4;
    vector drive = vector::Zero();
    for (int k = 0; k < 300; ++k) {
      CHECK(observe(o, arm_of.q, arm_of.dq, drive, {k, 1'000'000, 1}).norm() < 1e-3);
      drive = cca::gravity_torques(cca::body_pose<arm>(arm_of.q));
      arm_of.step(drive, vector::Zero(), 1e-3);
    }
  }

  TEST_CASE("a gap makes no step") {
    observer o;
    simulated arm_of;
    arm_of.dq << 0.5, -0.4, 0.3, 0.6, -0.2, 0.1, 0.4;
    vector drive = vector::Zero();
    for (int k = 0; k < 100; ++k) {
      vector q = arm_of.q;
      if (k > 40 && k < 80) q[3] = std::nan("");
      CHECK(observe(o, q, arm_of.dq, drive, {k, 1'000'000, 1}).norm() < 1e-3);
      drive = cca::gravity_torques(cca::body_pose<arm>(arm_of.q));
      arm_of.step(drive, vector::Zero(), 1e-3);
    }
  }

  TEST_CASE("numbers that are not finite") { laws::finite<finite_observer>(); }
}
