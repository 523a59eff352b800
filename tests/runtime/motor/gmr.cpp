// Gaussian mixture regression and the hidden Markov model against their formulas, written out.
#include <cca/motor/gmr.hpp>
#include <cca/motor/hmm_motion.hpp>

#include <Eigen/LU>

#include "rig.hpp"

using namespace motor_test;

namespace {

constexpr int K = 3;
struct time_axis : cca::dimension<"time"> {};
struct timeline : cca::space<cca::number, cca::axes<time_axis>> {};
struct turn : cca::space<cca::phase, cca::axes<stride>> {};
using motion = cca::gmr<timeline, leg, K>;
using rhythm = cca::gmr<turn, leg, K>;
using hidden = cca::hmm_motion<plane, K>;
using number = Eigen::Matrix<double, 1, 1>;

template <int D>
Eigen::Matrix<double, D, D> random_covariance(laws::ode_source& random) {
  Eigen::Matrix<double, D, D> a;
  for (int i = 0; i < D * D; ++i) a(i / D, i % D) = random(-1, 1);
  return a * a.transpose() + 0.1 * Eigen::Matrix<double, D, D>::Identity();
}

template <class Model, int D>
Model random_model(laws::ode_source& random) {
  Model m;
  for (int k = 0; k < K; ++k) {
    m.priors[k] = random(0.2, 1);
    for (int i = 0; i < D; ++i) m.means(i, k) = random(-1, 1);
    m.covariances[static_cast<std::size_t>(k)] = random_covariance<D>(random);
  }
  return m;
}

// Density of a Gaussian, with inverse and determinant.
double density(const Eigen::VectorXd& off, const Eigen::MatrixXd& S) {
  return std::exp(-0.5 * off.dot(S.inverse() * off)) / std::sqrt((2 * cca::pi * S).determinant());
}

struct dense {
  Eigen::VectorXd mean, h;
  Eigen::MatrixXd covariance;
};

template <class Model>
dense reference(const Model& m, const Eigen::VectorXd& priors, const Eigen::VectorXd& x) {
  const auto I = x.size(), O = m.means.rows() - I;
  dense r{Eigen::VectorXd::Zero(O), Eigen::VectorXd(K), Eigen::MatrixXd::Zero(O, O)};
  for (int k = 0; k < K; ++k) {
    const Eigen::MatrixXd S = m.covariances[static_cast<std::size_t>(k)];
    r.h[k] = priors[k] * density(x - m.means.col(k).head(I), S.topLeftCorner(I, I));
  }
  r.h /= r.h.sum();
  for (int k = 0; k < K; ++k) {
    const Eigen::MatrixXd S = m.covariances[static_cast<std::size_t>(k)];
    const Eigen::MatrixXd slope = S.bottomLeftCorner(O, I) * S.topLeftCorner(I, I).inverse();
    const Eigen::VectorXd y = m.means.col(k).tail(O) + slope * (x - m.means.col(k).head(I));
    r.mean += r.h[k] * y;
    r.covariance += r.h[k] * (S.bottomRightCorner(O, O) - slope * S.topRightCorner(I, O) + y * y.transpose());
  }
  r.covariance -= r.mean * r.mean.transpose();
  return r;
}

}  // namespace

TEST_CASE("Gaussian mixture regression equals its formula, mean and spread") {
  laws::ode_source random{std::mt19937_64{1}};
  for (int run = 0; run < 50; ++run) {
    motion m;
    m.p.mixture = random_model<motion::model, 3>(random);
    const number x(random(-2, 2));
    const auto [position, spread, usable] = m.process(given<cca::in<"input", timeline>>(x));
    const auto wanted = reference(m.p.mixture, m.p.mixture.priors, x);
    CHECK((position.vector() - wanted.mean).norm() < 1e-11);
    for (int i = 0; i < 2; ++i)
      CHECK(spread.vector()[i] == doctest::Approx(std::sqrt(wanted.covariance(i, i))).epsilon(1e-9));
  }
}

TEST_CASE(
    "one Gaussian is linear regression, and far from all Gaussians the nearest counts, without under- or "
    "overflow") {
  motion m;
  auto& mix = m.p.mixture;
  mix.priors << 1, 0, 0;
  mix.means.col(0) << 0.5, 1, -1;
  mix.covariances[0] << 0.04, 0.02, -0.01, 0.02, 1, 0, -0.01, 0, 1;
  const auto y = std::get<0>(m.process(given<cca::in<"input", timeline>>(number(0.9))));
  CHECK(y[hip{}] == doctest::Approx(1 + 0.5 * 0.4));
  CHECK(y[knee{}] == doctest::Approx(-1 - 0.25 * 0.4));
  mix.priors << 1, 1, 1;
  mix.means.col(1) << 100, 7, 0;
  mix.covariances[1] = 1e-4 * Eigen::Matrix3d::Identity();
  mix.covariances[2] = 1e-4 * Eigen::Matrix3d::Identity();
  mix.covariances[0] = 1e-4 * Eigen::Matrix3d::Identity();
  const auto far = std::get<0>(m.process(given<cca::in<"input", timeline>>(number(1e4))));
  CHECK(far[hip{}] == doctest::Approx(7));
}

TEST_CASE("a covariance that is indefinite over the output gives spread 0, not NaN") {
  motion m;
  m.p.mixture.priors << 1, 0, 0;
  m.p.mixture.covariances[0] << 1, 2, 0, 2, 1, 0, 0, 0, 0.25;  // the hip's conditional variance is 1 - 2 * 2
  CHECK_NOTHROW(cca::check_parameters(m.p));
  const auto spread = std::get<1>(m.process(given<cca::in<"input", timeline>>(number(0.3)))).vector();
  CHECK(spread[0] == 0);
  CHECK(spread[1] == doctest::Approx(0.5));
}

TEST_CASE("over a phase the Gaussians lie on the circle") {
  laws::ode_source random{std::mt19937_64{2}};
  rhythm r;
  r.p.mixture = random_model<rhythm::model, 3>(random);
  r.p.mixture.means.row(0) << 0.2, 2.3, 5.9;
  for (const double f : {-0.3, 0.0, 1.0, 3.0, 6.0})
    for (const double full : {-2 * cca::pi, 2 * cca::pi, 20 * cca::pi})
      CHECK((std::get<0>(r.process(given<cca::in<"input", turn>>(number(f)))).vector() -
             std::get<0>(r.process(given<cca::in<"input", turn>>(number(f + full)))).vector())
                .norm() < 1e-9);
  // Left and right of the cut it is the same point.
  for (auto& one : r.p.mixture.covariances) one(0, 0) += 1;
  CHECK((std::get<0>(r.process(given<cca::in<"input", turn>>(number(1e-9)))).vector() -
         std::get<0>(r.process(given<cca::in<"input", turn>>(number(2 * cca::pi - 1e-9)))).vector())
            .norm() < 1e-6);
}

TEST_CASE("the hidden Markov model equals its forward recursion, written out") {
  laws::ode_source random{std::mt19937_64{3}};
  hidden h;
  h.p.mixture = random_model<hidden::model, 4>(random);
  h.p.transitions << 0.9, 0.1, 0, 0, 0.8, 0.2, 0.3, 0, 0.7;
  cca::check_parameters(h.p);
  Eigen::VectorXd forward = h.p.mixture.priors;
  for (int k = 0; k < 40; ++k) {
    const Eigen::Vector2d x = random.vector<Eigen::Vector2d>(-1, 1);
    const Eigen::VectorXd predicted =
        k == 0 ? forward : Eigen::VectorXd(h.p.transitions.transpose() * forward);
    const auto wanted = reference(h.p.mixture, predicted, x);
    const auto [velocity, state, usable] = h.process(given<cca::in<"position", plane>>(x));
    forward = wanted.h;
    CHECK((velocity.vector() - wanted.mean).norm() < 1e-10);
    CHECK((h.states() - wanted.h).norm() < 1e-10);
    Eigen::Index likely = 0;
    wanted.h.maxCoeff(&likely);
    CHECK(state.vector()[0] == static_cast<double>(likely));
  }
}

TEST_CASE(
    "where a movement crosses itself the hidden state gives the direction, which the mixture alone cannot") {
  // First a stroke to the right through the origin, then one upwards through it.
  hidden h;
  auto& m = h.p.mixture;
  m.priors << 1, 1e-6, 1e-6;
  m.means.col(0) << 0, 0, 1, 0;    // rightwards
  m.means.col(1) << 1, -1, -1, 0;  // back, below
  m.means.col(2) << 0, 0, 0, 1;    // upwards
  m.covariances[0] = Eigen::Vector4d(0.3, 0.01, 0.01, 0.01).asDiagonal();
  m.covariances[1] = Eigen::Vector4d(0.1, 0.1, 0.01, 0.01).asDiagonal();
  m.covariances[2] = Eigen::Vector4d(0.01, 0.3, 0.01, 0.01).asDiagonal();
  h.p.transitions << 0.99, 0.01, 0, 0, 0.99, 0.01, 0.01, 0, 0.99;
  const auto at_origin = [&] {
    return std::get<0>(h.process(given<cca::in<"position", plane>>(Eigen::Vector2d(0, 0)))).vector();
  };
  for (double s = -1; s < -0.01; s += 0.1)
    (void)h.process(given<cca::in<"position", plane>>(Eigen::Vector2d(s, 0)));
  CHECK((at_origin() - Eigen::Vector2d(1, 0)).norm() < 0.1);
  for (int k = 0; k < 10; ++k) (void)h.process(given<cca::in<"position", plane>>(Eigen::Vector2d(1, -1)));
  CHECK(h.states()[1] > 0.9);
  for (double s = -1; s < -0.01; s += 0.1)
    (void)h.process(given<cca::in<"position", plane>>(Eigen::Vector2d(0, s)));
  CHECK((at_origin() - Eigen::Vector2d(0, 1)).norm() < 0.1);
  const auto blind = regress<2, 2, K>(
      m, hidden::weights::Constant(1), Eigen::Vector2d(0, 0),
      [](const Eigen::Vector2d& x, const Eigen::Vector2d& mean) { return Eigen::Vector2d(x - mean); });
  CHECK(std::abs(blind.mean[0] - blind.mean[1]) < 0.1);
}

TEST_CASE("invalid models are refused, a position that is not finite does no harm, and nothing allocates") {
  motion m;
  CHECK_NOTHROW(cca::check_parameters(m.p));
  auto bad = m.p;
  bad.mixture.covariances[1](0, 0) = -1;
  CHECK_THROWS_AS(cca::check_parameters(bad), cca::refused);
  bad = m.p, bad.mixture.covariances[0](0, 1) = 0.5;
  CHECK_THROWS_AS(cca::check_parameters(bad), cca::refused);
  bad = m.p, bad.mixture.priors.setZero();
  CHECK_THROWS_AS(cca::check_parameters(bad), cca::refused);
  hidden h;
  auto worse = h.p;
  worse.transitions(0, 0) = 0.5;
  CHECK_THROWS_AS(cca::check_parameters(worse), cca::refused);
  worse.transitions.row(0) << 1.5, 0, 0;
  CHECK_THROWS_AS(cca::check_parameters(worse), cca::refused);
  worse.transitions.row(0) << 1.5, -0.5, 0;
  CHECK_THROWS_AS(cca::check_parameters(worse), cca::refused);
  laws::ode_source random{std::mt19937_64{5}};
  m.p.mixture = random_model<motion::model, 3>(random);
  h.p.mixture = random_model<hidden::model, 4>(random);
  const auto lost =
      std::get<0>(h.process(given<cca::in<"position", plane>>(Eigen::Vector2d(std::nan(""), 0)))).vector();
  CHECK(lost.norm() == 0);
  const std::size_t before = laws::allocations();
  for (int k = 0; k < 100; ++k) {
    (void)m.process(given<cca::in<"input", timeline>>(number(0.01 * k)));
    (void)h.process(given<cca::in<"position", plane>>(Eigen::Vector2d(0.01 * k, 0)));
  }
  CHECK(laws::allocations() == before);
  CHECK(h.states().allFinite());
}
