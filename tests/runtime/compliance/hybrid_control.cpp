// Hybrid control: a force against a table, a position along it.
#include <cca/robot/compliance/hybrid_control.hpp>

#include "rig.hpp"

using namespace compliance_test;

namespace {

using hybrid = cca::hybrid_control<arm, "arm", angles, velocities, torques>;
using pose7 = Eigen::Matrix<double, 7, 1>;
using wanted_pose = cca::in<"reference", cca::pose_in<arm_base>>;
using wanted_force = cca::in<"wanted", cca::load_on<flange, flange>>;
using felt = cca::in<"measured", cca::load_on<flange, arm_base>>;

// The arm over a table: the normal is z of the reference, which points down into it.
struct wiping {
  hybrid control{};
  simulated body{bent, vector::Zero()};
  pose7 reference;
  Eigen::Vector3d normal;   // up from the table
  Eigen::Vector3d point;    // on the table
  double stiffness = 5000;  // N/m
  vector6 felt_now = vector6::Zero(), exerted = vector6::Zero();
  double unknown = 0;  // N away from the table, which no sensor feels
  std::int64_t k = 0;
  double cut = 0;

  // The table is turned away from z of the end by `tilt` rad.
  explicit wiping(double tilt = 0) {
    const cca::rigid end = cca::body_pose<arm>(bent).tip<"arm">();
    const cca::matrix3 task = end.turn * cca::rotation::matrix(cca::rotation::about<double>({1, 0, 0}, tilt));
    reference << end.at, cca::detail::quaternion_of(task);
    normal = -task.col(2);
    point = end.at - 0.01 * normal;  // 1 cm away
    control.on_start();
  }
  void step(double newton) {
    const cca::body_pose<arm> now(body.q);
    const double depth = normal.dot(point - now.tip<"arm">().at);
    felt_now << 0, 0, 0, std::max(0.0, stiffness * depth) * normal;
    const vector6 wanted = (vector6() << 0, 0, 0, 0, 0, newton).finished();
    const auto [torque, out, status, saturation] =
        control.process(given<wanted_pose>(reference), given<wanted_force>(wanted), given<felt>(felt_now),
                        angles_of(body.q), velocities_of(body.dq), {k++, 1'000'000, 1}, {});
    exerted = out.vector();
    cut = saturation.vector()[0];
    body.world.wrench = felt_now;
    body.world.wrench.tail<3>() += unknown * normal;
    body.hold(in_order(torque.vector()), 1e-3);
  }
};

}  // namespace

TEST_SUITE("hybrid control") {
  TEST_CASE("it finds the table and exerts the force, also where the table leans") {
    for (const double tilt : {0.0, 0.15}) {
      wiping one(tilt);
      for (int k = 0; k < 4000; ++k) one.step(10);
      CHECK(one.exerted[5] == doctest::Approx(10).epsilon(1e-6));
      const cca::rigid end = cca::body_pose<arm>(one.body.q).tip<"arm">();
      const Eigen::Vector3d away = end.at - one.reference.head<3>();
      CHECK((away - one.normal * one.normal.dot(away)).norm() < 1e-6);  // at its place along the table
      CHECK(one.body.dq.norm() < 1e-5);
    }
  }

  TEST_CASE("along the table it follows, while the force stays") {
    wiping one;
    for (int k = 0; k < 2000; ++k) one.step(10);
    one.control.p.stiffness.tail<3>().setConstant(3000);
    const Eigen::Vector3d from = one.reference.head<3>(),
                          along = cca::rotation::matrix(Eigen::Vector4d(one.reference.tail<4>())).col(0);
    double worst = 0, off = 0;
    for (int k = 0; k < 4000; ++k) {
      one.reference.head<3>() = from + 0.05 * std::sin(1.5e-3 * k) * along;
      one.step(10);
      if (k < 500) continue;
      worst = std::max(worst, std::abs(one.exerted[5] - 10));
      const Eigen::Vector3d away = cca::body_pose<arm>(one.body.q).tip<"arm">().at - one.reference.head<3>();
      off = std::max(off, (away - one.normal * one.normal.dot(away)).norm());
    }
    MESSAGE("largest error of the force " << worst << " N, of the place " << 1e3 * off << " mm");
    CHECK(worst < 1.5);
    CHECK(off < 0.01);
  }

  TEST_CASE("without the integral an error stays - at the largest force it does not wind up") {
    wiping one;
    one.unknown = 3;
    one.control.p.integral = 0;
    for (int k = 0; k < 3000; ++k) one.step(10);
    CHECK(std::abs(one.exerted[5] - 10) > 1);
    one.control.p.integral = 5;
    for (int k = 0; k < 4000; ++k) one.step(10);
    CHECK(one.exerted[5] == doctest::Approx(10).epsilon(1e-4));
    // A force that it may not exert, for ten seconds; then it is back within half a second.
    one.control.p.most_force[5] = 20;
    for (int k = 0; k < 10000; ++k) one.step(40);
    CHECK(one.cut == cca::status_of(cca::saturation::spring));
    CHECK(one.exerted[5] < 25);
    for (int k = 0; k < 500; ++k) one.step(10);
    CHECK(std::abs(one.exerted[5] - 10) < 0.5);
  }

  TEST_CASE("numbers that it can't use") {
    wiping one;
    for (int k = 0; k < 3000; ++k) one.step(10);
    const vector held = cca::gravity_torques(cca::body_pose<arm>(one.body.q)), v = vector::Constant(0.2);
    vector6 broken = one.felt_now;
    broken[4] = no_number;
    const auto call = [&](const vector6& load, const vector& q) {
      return one.control.process(given<wanted_pose>(one.reference),
                                 given<wanted_force>(vector6::Zero().eval()), given<felt>(load), angles_of(q),
                                 velocities_of(v), {0, 1'000'000, 1}, {});
    };
    const auto blind = call(broken, one.body.q);
    CHECK((in_order(std::get<0>(blind).vector()) - held).dot(v) < -0.1);
    CHECK(is(std::get<2>(blind), cca::input_status::unreadable));
    CHECK(std::get<0>(call(one.felt_now, vector::Constant(no_number))).vector().norm() == 0);
    one.step(10);
    CHECK(one.exerted[5] == doctest::Approx(10).epsilon(1e-3));  // the integral is as it was
  }
}
