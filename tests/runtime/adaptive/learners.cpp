// Every learner obeys the laws of a Learner, and agrees with the formulas of its source.
#include <Eigen/Dense>

#include <cca/adaptive/extreme_learning_machine.hpp>
#include <cca/adaptive/recursive_least_squares.hpp>
#include <cca/motor/gaussian_mixture_learning.hpp>
#include <cca/motor/gmr.hpp>
#include <cca/motor/hidden_markov_learning.hpp>

#include "../../laws/learner_laws.hpp"
#include "../../laws/request_laws.hpp"
#include "rig.hpp"

using namespace adaptive_test;

namespace {

using shape = cca::rhythmic_shape<leg, 25>;
using discrete = cca::discrete_shape<leg, 15>;
struct place : cca::space<cca::number, cca::axes<cca::x, cca::y>> {};
struct time_of_it : cca::space<cca::number, cca::axes<cca::x>> {};

// A periodic shape times its amplitude.
struct rhythmic_case {
  static shape::input input(laws::ode_source& random) { return {random(0, 2 * cca::pi), random(0.2, 1)}; }
  static shape::output truth(const shape::input& x) {
    return x[1] * Eigen::Vector2d(std::sin(x[0]), 0.5 * std::cos(2 * x[0] + 1));
  }
  static shape::input far() { return {1, 0.5}; }
};
// Trained on half a turn; the other half is outside.
template <class Case>
struct half_of : Case {
  static shape::input input(laws::ode_source& random) { return {random(0, cca::pi), random(0.2, 1)}; }
  static shape::input far() { return {1.5 * cca::pi, 0.5}; }
};
struct lwr_case : half_of<rhythmic_case> {
  using learner = cca::locally_weighted_regression<shape>;
  static constexpr double left = 0.06;
};
struct rls_case : half_of<rhythmic_case> {
  using learner = cca::recursive_least_squares<shape>;
  static constexpr double left = 0.01;
};
// Without its batch.
struct online_only : lwr_case::learner {
  static void batch() = delete;
};
struct online_only_case : lwr_case {
  using learner = online_only;
};
struct discrete_case {
  using learner = cca::locally_weighted_regression<discrete>;
  static constexpr double left = 0.2;
  static discrete::input input(laws::ode_source& random) {
    return discrete::input(std::exp(-2.5 * random(0, 1)));
  }
  static discrete::output truth(const discrete::input& x) {
    return x[0] * Eigen::Vector2d(std::sin(1.5 * std::log(x[0])), std::cos(std::log(x[0])));
  }
  static discrete::input far() { return discrete::input(std::exp(-4.5)); }
};
struct elm_case {
  using learner = cca::extreme_learning_machine<cca::elm_function<place, leg, 60>>;
  static constexpr double left = 1e-3;
  static Eigen::Vector2d input(laws::ode_source& random) { return {random(-1, 1), random(2, 3)}; }
  static Eigen::Vector2d truth(const Eigen::Vector2d& x) {
    return {std::sin(x[0]) * x[1], std::exp(-x[0] * x[0]) + x[1]};
  }
  static Eigen::Vector2d far() { return {3, 2.5}; }
};
struct gmr_case {
  using learner = cca::expectation_maximisation<cca::mixture_function<time_of_it, leg, 8>>;
  static constexpr double left = 0.06;
  using one = Eigen::Matrix<double, 1, 1>;
  static one input(laws::ode_source& random) { return one(random(0, 2)); }
  static Eigen::Vector2d truth(const one& x) { return {std::sin(3 * x[0]), 0.5 * std::cos(2 * x[0]) + 0.3}; }
  static one far() { return one(4); }
};

// Along a path, four times.
struct hidden_case {
  using learner = cca::baum_welch<cca::hidden_markov_function<leg, cca::velocity_of<leg>, 12>>;
  static constexpr double left = 0.06;
  static auto sequence(int count, std::uint64_t seed) {
    laws::ode_source random{std::mt19937_64{seed}};
    std::vector<laws::example_of<hidden_case>> all;
    for (int i = 0; i < count; ++i) {
      const int step = i % (count / 4);
      const double s = 8.0 * step / count + random(0, 1e-3);
      all.push_back({{s, 0.5 * std::sin(2 * s)}, {0.8, 0.8 * std::cos(2 * s)}, step == 0});
    }
    return all;
  }
  static Eigen::Vector2d far() { return {1, -2}; }
};

}  // namespace

TEST_CASE("locally weighted regression obeys the laws of a learner") {
  laws::learner<lwr_case>();
  laws::learner<discrete_case>();
}
TEST_CASE("recursive least squares obeys the laws of a learner") { laws::learner<rls_case>(); }
TEST_CASE("an extreme learning machine obeys the laws of a learner") { laws::learner<elm_case>(); }
TEST_CASE("a Gaussian mixture obeys the laws of a learner") { laws::learner<gmr_case>(); }
TEST_CASE("a hidden Markov model obeys the laws of a learner") { laws::learner<hidden_case>(); }
TEST_CASE("every learner answers every request, and does what it says") {
  laws::requests<laws::lone_learner<lwr_case>>();
  laws::requests<laws::lone_learner<discrete_case>>();
  laws::requests<laws::lone_learner<rls_case>>();
  laws::requests<laws::lone_learner<elm_case>>();
  laws::requests<laws::lone_learner<gmr_case>>();
  laws::requests<laws::lone_learner<hidden_case>>();
  laws::requests<laws::lone_learner<online_only_case>>();
}

TEST_CASE("locally weighted regression equals its formula, online as in a batch") {
  using learner = lwr_case::learner;
  const auto all = laws::examples<lwr_case>(400, 7);
  const auto known = learner::batch(all, {});
  learner::learned online;
  for (const auto& one : all) learner::step(online, one.x, one.y, {});
  CHECK(online.function.weights == known.function.weights);
  // Ijspeert et al. 2013, equation 2.14, written out: w_i = s^T G_i f / s^T G_i s.
  for (int i = 0; i < 25; ++i) {
    Eigen::Vector2d above = Eigen::Vector2d::Zero();
    double under = 0;
    for (const auto& one : all)
      above += one.x[1] * shape::activations(one.x)[i] * one.y,
          under += one.x[1] * one.x[1] * shape::activations(one.x)[i];
    if (under > 1e-9)
      CHECK((known.function.weights.col(i) - above / under).norm() < 1e-9 * (1 + (above / under).norm()));
  }
}

TEST_CASE("with forgetting it follows changes, and keeps regions that are not visited") {
  using learner = lwr_case::learner;
  learner::learned known, steady;
  const learner::settings forgets(0.95, 1.0);
  laws::ode_source random{std::mt19937_64{8}};
  const auto first = [&](double f) { return Eigen::Vector2d(std::sin(f), 1); };
  for (int i = 0; i < 3000; ++i) {
    const double f = random(0, 2 * cca::pi);
    learner::step(known, {f, 1.0}, first(f), forgets);
    learner::step(steady, {f, 1.0}, first(f), {});
  }
  for (int i = 0; i < 3000; ++i) {
    const double f = random(0, 1.5);
    learner::step(known, {f, 1.0}, {0, -1}, forgets);
    learner::step(steady, {f, 1.0}, {0, -1}, {});
  }
  CHECK((shape::answer(known.function, {0.75, 1.0}) - Eigen::Vector2d(0, -1)).norm() < 0.01);
  CHECK((shape::answer(steady.function, {0.75, 1.0}) - Eigen::Vector2d(0, -1)).norm() > 0.2);
  CHECK((shape::answer(known.function, {4.0, 1.0}) - first(4.0)).norm() < 0.05);
}

TEST_CASE("recursive least squares solves the normal equations, and P is their inverse") {
  using learner = rls_case::learner;
  const learner::settings s(1.0, 1e-3, 1.0);
  const auto all = laws::examples<rls_case>(400, 9);
  learner::learned online;
  for (const auto& one : all) learner::step(online, one.x, one.y, s);
  Eigen::Matrix<double, 25, 25> A = 1e-3 * Eigen::Matrix<double, 25, 25>::Identity();
  Eigen::Matrix<double, 25, 2> b = Eigen::Matrix<double, 25, 2>::Zero();
  for (const auto& one : all)
    A += shape::regressors(one.x) * shape::regressors(one.x).transpose(),
        b += shape::regressors(one.x) * one.y.transpose();
  const Eigen::Matrix<double, 2, 25> wanted = A.fullPivLu().solve(b).transpose();
  CHECK((online.function.weights - wanted).norm() < 1e-7 * wanted.norm());
  CHECK((learner::batch(all, s).function.weights - wanted).norm() < 1e-9 * wanted.norm());
  CHECK((online.uncertainty - A.inverse()).norm() < 1e-6 * A.inverse().norm());
}

TEST_CASE("recursive least squares follows changes, and its uncertainty does not wind up") {
  using learner = rls_case::learner;
  const learner::settings s(0.98, 1e-2, 1.0);
  learner::learned known;
  laws::ode_source random{std::mt19937_64{10}};
  for (int i = 0; i < 4000; ++i) {
    const double f = random(0, 2 * cca::pi);
    learner::step(known, {f, 1.0}, Eigen::Vector2d(std::sin(f), 1) * (i < 2000 ? 1 : -1), s);
  }
  CHECK((shape::answer(known.function, {1.0, 1.0}) - Eigen::Vector2d(-std::sin(1.0), -1)).norm() < 0.01);
  for (int i = 0; i < 100000; ++i)
    learner::step(known, {1.0, 1.0}, {-std::sin(1.0), -1}, s);  // always the same example
  CHECK(known.uncertainty.allFinite());
  CHECK(known.uncertainty.trace() < 2 * 25 / 1e-2);
  CHECK((shape::answer(known.function, {1.0, 1.0}) - Eigen::Vector2d(-std::sin(1.0), -1)).norm() < 0.01);
}

TEST_CASE("an extreme learning machine equals ridge regression over its hidden layer") {
  using learner = elm_case::learner;
  using function = learner::model;
  const learner::settings s(1e-3, 1.0, 0.1);
  const auto all = laws::examples<elm_case>(300, 11);
  const auto known = learner::batch(all, s);
  Eigen::MatrixXd H(300, 61), Y(300, 2);
  for (int t = 0; t < 300; ++t)
    H.row(t) = function::hidden(known.function, all[static_cast<std::size_t>(t)].x),
    Y.row(t) = all[static_cast<std::size_t>(t)].y;
  // The stationary point of |H W^T - Y|^2 + ridge |W|^2.
  const Eigen::MatrixXd gradient = H.transpose() * (H * known.function.weights.transpose() - Y) +
                                   1e-3 * known.function.weights.transpose();
  CHECK(gradient.norm() < 1e-8 * (H.transpose() * Y).norm());
}

TEST_CASE("the likelihood of a mixture grows with each iteration, and equals a direct sum of densities") {
  using learner = gmr_case::learner;
  const auto all = laws::examples<gmr_case>(500, 12);
  double last = -1e300;
  for (int n = 1; n <= 40; ++n) {
    const auto known = learner::batch(all, {1e-9, 0.0, n});
    CHECK(known.likelihood >= last - 1e-9);
    last = known.likelihood;
  }
  const auto known = learner::batch(all, {1e-6, 0.0, 3});
  double sum = 0;
  for (const auto& one : all) {
    Eigen::Vector3d z;
    z << one.x, one.y;
    double density = 0;
    for (int k = 0; k < 8; ++k) {
      const Eigen::Matrix3d& S = known.function.covariances[static_cast<std::size_t>(k)];
      const Eigen::Vector3d off = z - known.function.means.col(k);
      density += known.function.priors[k] * std::exp(-0.5 * off.dot(S.inverse() * off)) /
                 std::sqrt(std::pow(2 * cca::pi, 3) * S.determinant());
    }
    sum += std::log(density);
  }
  CHECK(known.likelihood == doctest::Approx(sum / 500).epsilon(1e-9));
  CHECK(std::string(known.function.check()).empty());
}

TEST_CASE("a region covers its examples, within twice the smallest possible radius") {
  std::vector<Eigen::Vector2d> ring;
  for (int i = 0; i < 400; ++i) ring.push_back({std::cos(i * cca::pi / 200), std::sin(i * cca::pi / 200)});
  const auto region = cca::covered_region<2, 40>::over(ring);
  for (const auto& x : ring) CHECK(region.contains(x, 0));
  CHECK(!region.contains({0, 0}, 0.1));  // the middle of a ring is empty
  CHECK(!region.contains({1.5, 0}, 0.1));
  // Forty arcs of a ring of radius sqrt(2), in units of the scatter: half a chord is the smallest radius.
  CHECK(region.radius <= 2 * std::sqrt(2.0) * 2 * std::sin(cca::pi / 80));
}
