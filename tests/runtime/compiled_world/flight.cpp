// Free flight in a compiled world: energy and momentum stay, to the second order of the step; copies go on
// bit for bit; derivatives by dual numbers.
#include <Eigen/Dense>
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "../dual.hpp"
#include "flights.hpp"

namespace laws {
std::size_t allocations();  // in tests/laws/allocations.cpp
}

using namespace compiled_test;
using test::dual;

namespace {

// Angular about the centre of mass, then linear; along the world's axes.
Eigen::Matrix<double, 6, 1> momentum(const sim::compiled_world<flying_oncilla>& w) {
  const sim::moving_frame base = w.frame(-1);
  const Eigen::Matrix3d& turn = base.where.turn;
  Eigen::Matrix<double, 22, 1> v;
  v << turn.transpose() * base.angular_velocity, turn.transpose() * base.velocity, speeds_of(w);
  const Eigen::Matrix<double, 6, 1> own = cca::floating_centroidal_momentum_matrix(pose_of(w)) * v;
  Eigen::Matrix<double, 6, 1> m;
  m << turn * own.head<3>(), turn * own.tail<3>();
  return m;
}
double error_of_momentum(int steps) {
  auto w = thrown<flying_oncilla>(steps);
  Eigen::Matrix<double, 6, 1> wanted = momentum(w);
  for (int i = 0; i < 300; ++i) w.advance({});
  wanted[5] -= 0.3 * 9.81 * robots::oncilla::body.mass();
  return (momentum(w) - wanted).norm();
}

template <class World>
bool same_bits(const World& a, const World& b) {
  return std::memcmp(&a.save().motion, &b.save().motion, sizeof a.save().motion) == 0;
}

// Where the tip of the arm's last joint is after 0.2 s, in its first angle, by the speed that the second
// joint starts with.
template <class Real>
Real swung(const Real& speed) {
  sim::compiled_world<limp_arm, Real> w;
  std::array<Real, 7> q{}, dq{};
  q[1] = Real(-0.7), q[3] = Real(-2.0), dq[0] = Real(1.0), dq[1] = speed;
  w.place(q, dq);
  for (int i = 0; i < 200; ++i) w.advance({});
  return w.joints()[0].angle;
}

}  // namespace

TEST_SUITE("compiled world: flight") {
  TEST_CASE_TEMPLATE("energy stays, to the second order", R, flying_oncilla, limp_arm) {
    const double whole = largest_change_of_energy(thrown<R>(2)),
                 half = largest_change_of_energy(thrown<R>(4));
    MESSAGE("J: ", whole, " in steps of 0.5 ms, ", half, " in steps of 0.25 ms");
    CHECK(half < 0.3 * whole);
    CHECK(half > 0.2 * whole);
    if (R::floats) CHECK(whole < 1e-6);
  }

  TEST_CASE("momentum stays, to the second order") {
    const double whole = error_of_momentum(2), half = error_of_momentum(4);
    MESSAGE("N s, N m s: ", whole, " in steps of 0.5 ms, ", half, " in steps of 0.25 ms");
    CHECK(whole < 1e-5);
    CHECK(half < 0.3 * whole);
  }

  TEST_CASE("the axis of a disc that spins fast nods as a top does, and no more") {
    const nutation n = nutation_of(spinning_disc());
    MESSAGE("relative error of the angle: ", n.error, ", of the rate: ", n.error_of_rate);
    CHECK(n.error < 1e-3);
    CHECK(n.error_of_rate < 2e-3);
  }

  TEST_CASE("copy, save and restore go on bit for bit, and nothing allocates") {
    auto w = thrown<flying_oncilla>(2);
    for (int i = 0; i < 50; ++i) w.advance({});
    auto copy = w;
    const auto saved = w.save();
    const std::size_t before = laws::allocations();
    for (int i = 0; i < 50; ++i) w.advance({}), copy.advance({});
    CHECK(laws::allocations() == before);
    CHECK(same_bits(w, copy));
    const auto there = w.save().motion.q;
    w.restore(saved);
    CHECK(w.save().motion.q != there);
    for (int i = 0; i < 50; ++i) w.advance({});
    CHECK(same_bits(w, copy));
  }

  TEST_CASE("a dual number as scalar gives the derivative") {
    const dual by_speed = swung(dual(0.8, 1));
    CHECK(by_speed.value == swung(0.8));
    const double d = 1e-4;
    const double difference = (swung(0.8 + d) - swung(0.8 - d)) / (2 * d);
    MESSAGE("by dual numbers ", by_speed.slope, ", by differences ", difference);
    CHECK(by_speed.slope == doctest::Approx(difference).epsilon(1e-6));
    CHECK(std::abs(by_speed.slope) > 1e-3);
  }
}
