// A reservoir continues the pattern of its teacher by itself.
#include <cca/motor/rcpg.hpp>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "rig.hpp"

using namespace motor_test;

namespace {

constexpr int N = 100;
using generator = cca::rcpg<plane, N>;
using teacher = cca::optional_in<"teacher", plane>;

// Two axes with harmonics, period 50 firings.
Eigen::Vector2d pattern(double k) {
  const double f = 2 * cca::pi * k / 50;
  return {0.5 * std::sin(f) + 0.2 * std::sin(2 * f + 1), 0.4 * std::cos(f) + 0.15 * std::cos(3 * f)};
}

Eigen::Vector2d taught(generator& g, int k) {
  return std::get<0>(g.process(wired<teacher>(pattern(k)))).vector();
}
Eigen::Vector2d free_run(generator& g) { return std::get<0>(g.process(teacher{})).vector(); }

// Ridge regression of the pattern on the activity under the teacher.
generator trained() {
  generator g;
  g.on_load();
  Eigen::Matrix<double, N + 1, N + 1> A = 1e-6 * Eigen::Matrix<double, N + 1, N + 1>::Identity();
  Eigen::Matrix<double, N + 1, 2> b = Eigen::Matrix<double, N + 1, 2>::Zero();
  laws::ode_source noise{std::mt19937_64{4}};
  for (int k = 0; k < 3000; ++k) {
    const Eigen::Vector2d y = pattern(k);
    // Noise in the feedback makes the readout robust against its own errors.
    g.process(wired<teacher>(Eigen::Vector2d(y + noise.vector<Eigen::Vector2d>(-0.01, 0.01))));
    if (k < 200) continue;
    A += g.activity() * g.activity().transpose(), b += g.activity() * y.transpose();
  }
  g.p.readout = A.ldlt().solve(b).transpose();
  return g;
}

}  // namespace

TEST_CASE("the spectral radius is the requested one, and the seed determines the network") {
  cca::reservoir<2, 60, 10> one, same, other;
  one.make({7, 0.9, 1, 0.2}), same.make({7, 0.9, 1, 0.2}), other.make({8, 0.9, 1, 0.2});
  const auto matrix = [](const auto& r) {
    Eigen::MatrixXd W(60, 60);
    for (int j = 0; j < 60; ++j) W.col(j) = r.recur(Eigen::Matrix<double, 60, 1>::Unit(j));
    return W;
  };
  CHECK(Eigen::EigenSolver<Eigen::MatrixXd>(matrix(one)).eigenvalues().cwiseAbs().maxCoeff() ==
        doctest::Approx(0.9).epsilon(0.02));
  CHECK(matrix(one) == matrix(same));
  CHECK(matrix(one) != matrix(other));
  CHECK((matrix(one).array() != 0).rowwise().count().maxCoeff() <= 10);
}

TEST_CASE(
    "a single unit leaks to its bias, a teacher acts through the feedback, each sample once, and a load "
    "resets the network") {
  generator g;
  g.p.spectral_radius = 0, g.p.feedback = 0, g.p.bias = 3, g.p.leak = 0.25;
  g.on_load();
  Eigen::Matrix<double, N, 1> last;
  for (int k = 0; k < 200; ++k) (void)taught(g, k);
  last = g.activity().head<N>();
  CHECK(last.cwiseAbs().maxCoeff() < 1);  // tanh
  CHECK(last.cwiseAbs().maxCoeff() > 0.9);
  g.on_load();
  CHECK(g.activity().head<N>().norm() == 0);
  for (int k = 0; k < 20; ++k) {
    (void)taught(g, k);  // no effect: the feedback is 0
    CHECK((g.activity().head<N>() - (1 - std::pow(0.75, k + 1)) * last).norm() < 1e-9);
  }
  generator a = trained(), b = a;
  for (int k = 0; k < 10; ++k)
    (void)a.process(wired<teacher>(pattern(k))), (void)b.process(wired<teacher>(pattern(k)));
  for (int k = 0; k < 10; ++k)
    CHECK(std::get<0>(a.process(wired<teacher>(Eigen::Vector2d(9, 9), false))).vector() ==
          std::get<0>(b.process(teacher{})).vector());
  generator used = a, fresh;
  fresh.p = a.p;
  used.on_load(), fresh.on_load();
  for (int k = 0; k < 10; ++k) CHECK(free_run(used) == free_run(fresh));
}

TEST_CASE("echo states: two networks in different states converge under the same input") {
  generator a, b;
  a.on_load(), b.on_load();
  for (int k = 0; k < 100; ++k) (void)a.process(wired<teacher>(Eigen::Vector2d(0.9, -0.9)));
  CHECK((a.activity() - b.activity()).norm() > 0.5);
  for (int k = 0; k < 600; ++k) (void)taught(a, k), (void)taught(b, k);
  CHECK((a.activity() - b.activity()).norm() < 1e-6);
}

TEST_CASE("a trained generator continues for twenty periods without its teacher") {
  generator g = trained();
  int k = 0;
  for (; k < 300; ++k) CHECK(taught(g, k) == pattern(k));
  double worst = 0;
  for (; k < 1300; ++k) worst = std::max(worst, (free_run(g) - pattern(k)).norm());
  CHECK(worst < 0.05);  // the amplitude is 0.6; includes the drift of twenty periods
}

TEST_CASE("a trained network without a teacher falls into the pattern from rest: it is a limit cycle") {
  generator g = trained();
  g.on_load();
  std::vector<Eigen::Vector2d> seen;
  for (int k = 0; k < 3000; ++k) seen.push_back(free_run(g));
  double best = 1e9;  // over all phases
  for (int shift = 0; shift < 500; ++shift) {
    double worst = 0;
    for (int k = 0; k < 50; ++k)
      worst = std::max(worst, (seen[static_cast<std::size_t>(2900 + k)] - pattern(k + shift / 10.0)).norm());
    best = std::min(best, worst);
  }
  CHECK(best < 0.05);
}

TEST_CASE(
    "without readout it is silent, the first firing makes the network, NaN is ignored, and nothing "
    "allocates") {
  generator g;
  const std::size_t before = laws::allocations();
  for (int k = 0; k < 100; ++k) CHECK(free_run(g).norm() == 0);
  const auto one = g.activity();
  (void)g.process(wired<teacher>(Eigen::Vector2d(std::nan(""), 0)));
  (void)free_run(g);
  const std::size_t after = laws::allocations();
  CHECK(g.activity().allFinite());
  CHECK(one.allFinite());
  CHECK(one.head<N>().norm() > 0);  // because of the bias
  CHECK(before == after);
}
