// A learner for Gaussian mixture regression: expectation maximisation of a mixture over inputs and outputs.
//
//   r_kt = prior_k N(z_t; m_k, S_k) / sum_k     responsibilities, z = (x, y)
//   n_k = sum_t r_kt,  prior_k = n_k / T,  m_k = sum r_kt z_t / n_k
//   S_k = sum r_kt (z_t - m_k)(z_t - m_k)^T / n_k + floor
//
// It begins with examples that lie far apart (covered_region.hpp) and assigns each example to the nearest of
// them. It ends when the likelihood per example grows by less than `tolerance`, or after `iterations`.
// `floor` keeps a Gaussian with few examples from collapsing; because of it the likelihood may fall slightly
// in the last steps. Trained region: inputs at least as likely as the least likely example. It learns in
// batches only. The model has the parameters of cca::gmr: `c.get<"motion">().p.mixture = learned.function`.
//
// Examples and inputs that are NaN or infinite don't come here (learner.hpp), so the mixture stays finite.
//
// Errors: none. Cost: a batch takes K (I + O)^3 operations per example and iteration.
// Source: Dempster, Laird, Rubin, Maximum likelihood from incomplete data via the EM algorithm, Journal of
// the Royal Statistical Society B 39, 1977; regression: equations/gaussian_mixture.hpp. Checked: the
// likelihood grows and equals a direct sum of densities. Example: tests/runtime/adaptive/learners.cpp.
#pragma once

#include <limits>
#include <vector>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math.hpp>
#include <cca/adaptive/numerics/covered_region.hpp>
#include <cca/adaptive/learner.hpp>
#include <cca/component/field_types.hpp>
#include <cca/motor/equations/gaussian_mixture.hpp>
#include <cca/motor/spaces.hpp>
#include <cca/space/info.hpp>

namespace cca {

template <detail::LinearSpace Input, detail::LinearSpace S, int K>
struct mixture_function {
  using from = Input;
  using to = S;
  using parameters = gaussian_mixture<Input::size, S::size, K>;
  using input = typename parameters::input;
  using output = typename parameters::output;
  static constexpr int I = Input::size, O = S::size, count = K;

  static output answer(const parameters& p, const input& x) {
    return regress<I, O, K>(p, p.priors, x,
                            [](const input& at, const input& mean) { return input(at - mean); })
        .mean;
  }
  static std::string title() {
    return "mixture_function from " + std::string(detail::space_of<Input>.name) + " to " +
           std::string(detail::space_of<S>.name) + " with " + std::to_string(K) + " Gaussians";
  }
};

template <class Model>
struct expectation_maximisation {
  using model = Model;
  using input = typename model::input;
  using output = typename model::output;
  using parameters = typename model::parameters;
  static constexpr int size = model::I + model::O, K = model::count;
  using point = Eigen::Matrix<double, size, 1>;
  using square = Eigen::Matrix<double, size, size>;
  static constexpr std::string_view name = "expectation_maximisation";

  struct settings {
    BOOST_HANA_DEFINE_STRUCT(settings,
                             (detail::variance_floor, floor),
                             (bounded<double, 0, infinity>, tolerance),
                             (bounded<int, 1, 10000>, iterations));
    constexpr settings(double least = 1e-6, double small = 1e-6, int most = 200)
        : floor(least), tolerance(small), iterations(most) {}
  };

  struct learned {
    BOOST_HANA_DEFINE_STRUCT(learned,
                             (parameters, function),
                             (double, least_likely),
                             (double, likelihood));  // both are logarithms, the second per example
    learned() : function(), least_likely(std::numeric_limits<double>::max()), likelihood(0) {}
  };

  static bool inside(const learned& known, const input& x, const settings&) {
    return detail::log_likelihood(known.function, known.function.priors, x) >= known.least_likely;
  }

  static learned batch(std::span<const example<model>> examples, const settings& s) {
    learned known;
    if (examples.empty()) return known;
    std::vector<point> points(examples.size());
    for (std::size_t t = 0; t < points.size(); ++t) points[t] << examples[t].x, examples[t].y;
    Eigen::MatrixXd r = first_guess(points);
    known.likelihood = -std::numeric_limits<double>::max();
    for (int i = 0; i < s.iterations; ++i) {
      maximise(known.function, points, r, s.floor);
      const double likelihood = expect(known.function, points, r);
      const bool done = likelihood - known.likelihood < s.tolerance;
      known.likelihood = likelihood;
      if (done) break;
    }
    for (const auto& one : examples)
      known.least_likely =
          std::min(known.least_likely, detail::log_likelihood(known.function, known.function.priors, one.x));
    return known;
  }

private:
  // Assigns each example to the nearest of K examples that lie far apart.
  static Eigen::MatrixXd first_guess(const std::vector<point>& points) {
    const auto apart = covered_region<size, K>::over(points);
    const point closeness = apart.width.cwiseInverse();
    Eigen::MatrixXd r = Eigen::MatrixXd::Zero(K, static_cast<Eigen::Index>(points.size()));
    for (std::size_t t = 0; t < points.size(); ++t) {
      Eigen::Matrix<double, K, 1> distances;
      for (int k = 0; k < K; ++k)
        distances[k] = math::squared_norm(closeness.cwiseProduct(apart.centres.col(k) - points[t]));
      Eigen::Index nearest = 0;
      distances.minCoeff(&nearest);
      r(nearest, static_cast<Eigen::Index>(t)) = 1;
    }
    return r;
  }
  static void maximise(parameters& p,
                       const std::vector<point>& points,
                       const Eigen::MatrixXd& r,
                       double floor) {
    for (int k = 0; k < K; ++k) {
      const double n = std::max(math::sum(r.row(k)), 1e-12);
      point mean = point::Zero();
      for (std::size_t t = 0; t < points.size(); ++t) mean += r(k, static_cast<Eigen::Index>(t)) * points[t];
      mean /= n;
      square S = square::Zero();
      for (std::size_t t = 0; t < points.size(); ++t)
        S += r(k, static_cast<Eigen::Index>(t)) * (points[t] - mean) * (points[t] - mean).transpose();
      p.priors[k] = n / static_cast<double>(points.size());
      p.means.col(k) = mean;
      p.covariances[static_cast<std::size_t>(k)] =
          detail::above_floor<size>((S + S.transpose()) / (2 * n), floor);
    }
  }
  static double expect(const parameters& p, const std::vector<point>& points, Eigen::MatrixXd& r) {
    double sum = 0;
    for (std::size_t t = 0; t < points.size(); ++t) {
      Eigen::Matrix<double, K, 1> each;
      for (int k = 0; k < K; ++k)
        each[k] =
            math::log(p.priors[k]) +
            detail::log_density<size>(points[t] - p.means.col(k), p.covariances[static_cast<std::size_t>(k)]);
      const double all = detail::log_sum(each);
      for (int k = 0; k < K; ++k) r(k, static_cast<Eigen::Index>(t)) = math::exp(each[k] - all);
      sum += all;
    }
    return sum / static_cast<double>(points.size());
  }
};

}  // namespace cca
