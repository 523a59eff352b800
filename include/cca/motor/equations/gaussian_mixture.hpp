// Gaussian mixture regression: K Gaussians over an input of I and an output of O numbers give the expected
// output for an input.
//
//   h_k(x)  = prior_k N(x; m_k^x, S_k^xx) / sum            responsibilities
//   y(x)    = sum h_k y_k,   y_k = m_k^y + S_k^yx S_k^xx^-1 (x - m_k^x)
//   cov(x)  = sum h_k (S_k^yy - S_k^yx S_k^xx^-1 S_k^xy + y_k y_k^T) - y y^T
//
// The model is a struct that a file can hold: `priors`, `means` (one column per Gaussian: input, then
// output), `covariances`. Preconditions, which `check()` tests: the input blocks of the covariances are
// positive definite, with standard deviations of at least 1e-12, and no number is above 1e12 (covariances:
// 1e24). Far from all Gaussians the nearest one counts; nothing under- or overflows for inputs up to 1e12.
// Cost: K
// factorisations of I x I.
// Source: Calinon, Guenter, Billard, On learning, representing, and generalizing a task in a humanoid robot,
// IEEE Transactions on Systems, Man, and Cybernetics B 37, 2007 (regression); Calinon, A tutorial on
// task-parameterized movement learning and retrieval, Intelligent Service Robotics 9, 2016 (covariance of the
// mixture). Checked against the formulas above with inverses and determinants, and against linear regression
// (tests/runtime/motor/gmr.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <numbers>
#include <string_view>

#include <cca/base/math/positive_matrix.hpp>
#include <cca/base/math/reductions.hpp>
#include <cca/base/math.hpp>
#include <cca/base/reflect.hpp>
#include <cca/base/eigen.hpp>
#include <cca/component/field_types.hpp>

namespace cca {

template <int I, int O, int K>
struct gaussian_mixture {
  using input = Eigen::Matrix<double, I, 1>;
  using output = Eigen::Matrix<double, O, 1>;
  using weights = Eigen::Matrix<double, K, 1>;
  using mean_matrix = Eigen::Matrix<double, I + O, K>;
  using covariance_array = std::array<Eigen::Matrix<double, I + O, I + O>, static_cast<std::size_t>(K)>;

  BOOST_HANA_DEFINE_STRUCT(gaussian_mixture,
                           (weights, priors),
                           (mean_matrix, means),
                           (covariance_array, covariances));

  // K equal Gaussians at the origin.
  gaussian_mixture() : priors(weights::Constant(1.0 / K)), means(mean_matrix::Zero()) {
    for (auto& one : covariances) one.setIdentity();
  }

  std::string_view check() const {
    if (priors.minCoeff() < 0 || !(math::sum(priors) > 0))
      return "the priors are not weights: no prior may be negative, and not all may be zero";
    if (priors.maxCoeff() > 1e12 || means.cwiseAbs().maxCoeff() > 1e12)
      return "a prior or a mean is above 1e12";
    for (const auto& one : covariances) {
      if (one.cwiseAbs().maxCoeff() > 1e24) return "a covariance is above 1e24";
      if (math::norm(one - one.transpose()) > 1e-9 * math::norm(one)) return "a covariance is not symmetric";
      const detail::positive_matrix<I> factor(block(one));
      for (int i = 0; i < I; ++i) {
        if (!(factor.diagonal(i) > 0)) return "a covariance is not positive definite over the input";
        if (factor.diagonal(i) < 1e-12) return "a standard deviation over the input is below 1e-12";
      }
    }
    return "";
  }

  static Eigen::Matrix<double, I, I> block(const Eigen::Matrix<double, I + O, I + O>& whole) {
    return whole.template topLeftCorner<I, I>();
  }
};

namespace detail {

inline constexpr double log_of_turn = math::log(2 * std::numbers::pi);

// Of a covariance, by its factor.
template <int N>
double half_log_determinant(const positive_matrix<N>& factor) {
  double sum = 0;
  for (int i = 0; i < N; ++i) sum += math::log(factor.diagonal(i));
  return sum;
}

// log N(x; m, S), where off = x - m.
template <int N>
double log_density(const Eigen::Matrix<double, N, 1>& off, const Eigen::Matrix<double, N, N>& S) {
  const positive_matrix<N> factor(S);
  return -0.5 * math::squared_norm(factor.forward(off)) - half_log_determinant(factor) -
         0.5 * N * log_of_turn;
}

// What the learners of Gaussians add to each variance.
using variance_floor = bounded<double, 1e-12, 1e12>;

// A covariance of examples plus `floor` in each direction. Where the examples lie in a plane, far apart,
// rounding can leave it without a Cholesky factor: then so much more is added that it has one.
template <int N>
Eigen::Matrix<double, N, N> above_floor(const Eigen::Matrix<double, N, N>& covariance, double floor) {
  using square = Eigen::Matrix<double, N, N>;
  square made = covariance + floor * square::Identity();
  double more = std::max(1e-12, 1e-16 * math::trace(made));
  for (int i = 0; i < 40 && !positive_matrix<N>(made).is_sound(); ++i, more *= 10)
    made += more * square::Identity();
  return made;
}

// The logarithm of a sum, from the logarithms of its terms.
template <class Logarithms>
double log_sum(const Logarithms& logarithms) {
  const double top = logarithms.maxCoeff();
  double sum = 0;
  for (int i = 0; i < logarithms.size(); ++i) sum += math::exp(logarithms[i] - top);
  return top + math::log(sum);
}

// The logarithm of the likelihood of an input, with these priors.
template <int I, int O, int K>
double log_likelihood(const gaussian_mixture<I, O, K>& model,
                      const Eigen::Matrix<double, K, 1>& priors,
                      const Eigen::Matrix<double, I, 1>& x) {
  Eigen::Matrix<double, K, 1> each;
  for (int k = 0; k < K; ++k)
    each[k] =
        math::log(priors[k]) + log_density<I>(x - model.means.col(k).template head<I>(),
                                              model.block(model.covariances[static_cast<std::size_t>(k)]));
  return log_sum(each);
}

}  // namespace detail

// The answer for one input: mean, covariance, and the share of each Gaussian.
template <int O, int K>
struct regression {
  Eigen::Matrix<double, O, 1> mean;
  Eigen::Matrix<double, O, O> covariance;
  Eigen::Matrix<double, K, 1> responsibilities;
};

// `priors` replaces those of the model: a hidden Markov model predicts its own. `difference(x, mean)` is
// x - mean; on a circle it takes the shorter way.
template <int I, int O, int K, class Difference>
regression<O, K> regress(const gaussian_mixture<I, O, K>& model,
                         const Eigen::Matrix<double, K, 1>& priors,
                         const Eigen::Matrix<double, I, 1>& x,
                         Difference difference) {
  using output = Eigen::Matrix<double, O, 1>;
  Eigen::Matrix<double, K, 1> logarithm;
  Eigen::Matrix<double, O, K> answers;
  std::array<Eigen::Matrix<double, O, O>, static_cast<std::size_t>(K)> spreads;
  for (int k = 0; k < K; ++k) {
    const auto& S = model.covariances[static_cast<std::size_t>(k)];
    const detail::positive_matrix<I> factor(model.block(S));
    const Eigen::Matrix<double, I, 1> off =
        difference(x, Eigen::Matrix<double, I, 1>(model.means.col(k).template head<I>()));
    const Eigen::Matrix<double, I, O> slope =
        factor.solve(Eigen::Matrix<double, I, O>(S.template topRightCorner<I, O>()));
    logarithm[k] = math::log(priors[k]) - detail::half_log_determinant(factor) -
                   0.5 * math::squared_norm(factor.forward(off));
    answers.col(k) = model.means.col(k).template tail<O>() + math::product(slope.transpose(), off);
    spreads[static_cast<std::size_t>(k)] =
        S.template bottomRightCorner<O, O>() -
        math::product(slope.transpose(), S.template topRightCorner<I, O>());
  }
  regression<O, K> result;
  const double top = logarithm.maxCoeff();
  for (int k = 0; k < K; ++k) result.responsibilities[k] = math::exp(logarithm[k] - top);
  result.responsibilities /= math::sum(result.responsibilities);
  result.mean = math::product(answers, result.responsibilities);
  result.covariance.setZero();
  for (int k = 0; k < K; ++k) {
    const output off = answers.col(k) - result.mean;
    result.covariance +=
        result.responsibilities[k] * (spreads[static_cast<std::size_t>(k)] + off * off.transpose());
  }
  return result;
}

}  // namespace cca
