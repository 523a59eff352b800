// A learner for hidden Markov models of movements: Baum and Welch, from one or more demonstrations.
//
//   b_k(t) = N(z_t; m_k, S_k), z = (x, y)
//   g_k(t)                the probability of state k at t, given its whole demonstration (forward-backward)
//   x_jk(t)               that of states j and k at t and t + 1
//   prior_k = mean of g_k over the beginnings,  a_jk = sum_t x_jk / sum_t sum_k x_jk
//   m_k = sum g_k z / sum g_k,  S_k = sum g_k (z - m_k)(z - m_k)^T / sum g_k + floor
//
// hidden_markov_function<From, To, K> is the model: To is the velocity for cca::hmm_motion, the attractor for
// cca::hmm_module. Its parameters are those of cca::hmm_motion and `occupancy`, the share of each state in
// the demonstrations; `answer` is the regression with these shares, without any history.
//
// It begins with each demonstration cut into K parts of equal length, and with `unseen`, the share of each
// beginning and transition that this does not show (0: it can only begin with the first part, and go on to
// the next). It ends when the likelihood per example grows by less than `tolerance`, or after `iterations`.
// `floor` keeps a Gaussian with few examples from collapsing; because of it the likelihood may fall slightly
// in the last steps. A state that is never left keeps itself. Trained region: inputs at least as likely as
// the least likely example. It learns in batches only.
//
// Transitions are those from one example to the next, so they belong to the clock of the demonstrations.
// Examples and inputs that are NaN or infinite don't come here (learner.hpp), so the model stays finite.
//
// Errors: none. Cost: a batch takes K ((From + To)^3 + K) operations per example and iteration; an answer
// those of the regression. Source: Baum, Petrie, Soules, Weiss, A maximization technique occurring in the
// statistical analysis of probabilistic functions of Markov chains, Annals of Mathematical Statistics 41,
// 1970; several sequences and scaling: Rabiner, A tutorial on hidden Markov models and selected applications
// in speech recognition, Proceedings of the IEEE 77, 1989; for movements: Calinon, D'halluin, Sauser,
// Caldwell, Billard, IEEE Robotics and Automation Magazine 17, 2010. Checked against the sums over all
// sequences of states, written out, and against pomegranate, which shares no code with it. Example:
// tests/runtime/motor/hidden_markov.cpp.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math.hpp>
#include <cca/adaptive/learner.hpp>
#include <cca/component/field_types.hpp>
#include <cca/motor/equations/gaussian_mixture.hpp>
#include <cca/motor/spaces.hpp>
#include <cca/space/info.hpp>

namespace cca {

template <detail::LinearSpace From, detail::LinearSpace To, int K>
struct hidden_markov_function {
  using from = From;
  using to = To;
  static constexpr int I = From::size, O = To::size, count = K;
  static constexpr bool is_sequence = true;
  using states = gaussian_mixture<I, O, K>;
  using input = typename states::input;
  using output = typename states::output;
  using weights = typename states::weights;
  using transition_matrix = Eigen::Matrix<double, K, K>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (states, mixture),
                             (transition_matrix, transitions),
                             (weights, occupancy));
    parameters()
        : mixture(), transitions(transition_matrix::Identity()), occupancy(weights::Constant(1.0 / K)) {}
  };

  // With these shares of the states.
  static regression<O, K> regress_with(const parameters& p, const weights& shares, const input& x) {
    return regress<I, O, K>(p.mixture, shares, x,
                            [](const input& at, const input& mean) { return input(at - mean); });
  }
  static output answer(const parameters& p, const input& x) { return regress_with(p, p.occupancy, x).mean; }
  static std::string title() {
    return "hidden_markov_function from " + std::string(detail::space_of<From>.name) + " to " +
           std::string(detail::space_of<To>.name) + " with " + std::to_string(K) + " states";
  }
};

template <SequenceModel Model>
struct baum_welch {
  using model = Model;
  using input = typename model::input;
  using output = typename model::output;
  using parameters = typename model::parameters;
  using weights = typename model::weights;
  using transition_matrix = typename model::transition_matrix;
  static constexpr int size = model::I + model::O, K = model::count;
  using point = Eigen::Matrix<double, size, 1>;
  using square = Eigen::Matrix<double, size, size>;
  static constexpr std::string_view name = "baum_welch";

  struct settings {
    BOOST_HANA_DEFINE_STRUCT(settings,
                             (detail::variance_floor, floor),
                             (bounded<double, 0, infinity>, tolerance),
                             (bounded<int, 1, 10000>, iterations),
                             (bounded<double, 0, 1>, unseen));
    constexpr settings(double least = 1e-6, double small = 1e-6, int most = 200, double elsewhere = 1e-3)
        : floor(least), tolerance(small), iterations(most), unseen(elsewhere) {}
  };

  struct learned {
    BOOST_HANA_DEFINE_STRUCT(learned,
                             (parameters, function),
                             (double, least_likely),
                             (double, likelihood));  // both are logarithms, the second per example
    learned() : function(), least_likely(std::numeric_limits<double>::max()), likelihood(0) {}
  };

  static bool inside(const learned& known, const input& x, const settings&) {
    return detail::log_likelihood(known.function.mixture, known.function.occupancy, x) >= known.least_likely;
  }

  static learned batch(std::span<const example<model>> examples, const settings& s) {
    learned known;
    if (examples.empty()) return known;
    std::vector<point> points(examples.size());
    for (std::size_t t = 0; t < points.size(); ++t) points[t] << examples[t].x, examples[t].y;
    const auto ends = ends_of(examples);
    expectation e = first_guess(points.size(), ends, s.unseen);
    known.likelihood = -std::numeric_limits<double>::max();
    for (int i = 0; i < s.iterations; ++i) {
      maximise(known.function, points, e, s.floor);
      const double likelihood = expect(known.function, points, ends, e);
      const bool done = likelihood - known.likelihood < s.tolerance;
      known.likelihood = likelihood;
      if (done) break;
    }
    for (const auto& one : examples)
      known.least_likely =
          std::min(known.least_likely,
                   detail::log_likelihood(known.function.mixture, known.function.occupancy, one.x));
    return known;
  }

private:
  using columns = Eigen::Matrix<double, K, Eigen::Dynamic>;
  struct expectation {
    columns state;               // g: a column for each example
    weights beginnings;          // the sum of the g of all beginnings
    transition_matrix passages;  // the sum of all x
  };

  // Where each demonstration ends: one past its last example.
  static std::vector<std::size_t> ends_of(std::span<const example<model>> examples) {
    std::vector<std::size_t> ends;
    for (std::size_t t = 1; t < examples.size(); ++t)
      if (examples[t].begins) ends.push_back(t);
    ends.push_back(examples.size());
    return ends;
  }

  static expectation first_guess(std::size_t count, const std::vector<std::size_t>& ends, double unseen) {
    expectation e{columns::Zero(K, static_cast<Eigen::Index>(count)), weights::Zero(),
                  transition_matrix::Zero()};
    std::size_t begin = 0;
    for (const std::size_t end : ends) {
      const auto part = [&](std::size_t t) {
        return static_cast<Eigen::Index>(static_cast<std::size_t>(K) * (t - begin) / (end - begin));
      };
      for (std::size_t t = begin; t < end; ++t) {
        e.state(part(t), static_cast<Eigen::Index>(t)) = 1;
        if (t + 1 < end) e.passages(part(t), part(t + 1)) += 1;
      }
      begin = end;
    }
    e.beginnings.setConstant(unseen * static_cast<double>(ends.size()));
    e.beginnings[0] += static_cast<double>(ends.size());
    for (int k = 0; k < K; ++k)
      e.passages.row(k).array() += unseen * std::max(1.0, math::sum(e.passages.row(k)));
    return e;
  }

  static void maximise(parameters& p, const std::vector<point>& points, const expectation& e, double floor) {
    p.mixture.priors = e.beginnings / math::sum(e.beginnings);
    for (int k = 0; k < K; ++k) {
      if (const double left = math::sum(e.passages.row(k)); left > 0)
        p.transitions.row(k) = e.passages.row(k) / left;
      else p.transitions.row(k) = transition_matrix::Identity().row(k);
      const double n = std::max(math::sum(e.state.row(k)), 1e-12);
      point mean = point::Zero();
      for (std::size_t t = 0; t < points.size(); ++t)
        mean += e.state(k, static_cast<Eigen::Index>(t)) * points[t];
      mean /= n;
      square S = square::Zero();
      for (std::size_t t = 0; t < points.size(); ++t)
        S += e.state(k, static_cast<Eigen::Index>(t)) * (points[t] - mean) * (points[t] - mean).transpose();
      p.occupancy[k] = n / static_cast<double>(points.size());
      p.mixture.means.col(k) = mean;
      p.mixture.covariances[static_cast<std::size_t>(k)] =
          detail::above_floor<size>((S + S.transpose()) / (2 * n), floor);
    }
  }

  // Gives the likelihood of the parameters, and what the states are under them.
  static double expect(const parameters& p,
                       const std::vector<point>& points,
                       const std::vector<std::size_t>& ends,
                       expectation& e) {
    columns density(K, static_cast<Eigen::Index>(points.size()));  // up to a factor for each example
    double sum = 0;
    for (std::size_t t = 0; t < points.size(); ++t) {
      weights each;
      for (int k = 0; k < K; ++k)
        each[k] = detail::log_density<size>(points[t] - p.mixture.means.col(k),
                                            p.mixture.covariances[static_cast<std::size_t>(k)]);
      const double top = each.maxCoeff();
      sum += top;
      // Above zero, so that no state is impossible where all the likely ones are.
      for (int k = 0; k < K; ++k)
        density(k, static_cast<Eigen::Index>(t)) = std::max(math::exp(each[k] - top), 1e-280);
    }
    e.passages.setZero();
    e.beginnings.setZero();
    Eigen::Index begin = 0;
    for (const std::size_t one : ends) {
      const auto end = static_cast<Eigen::Index>(one);
      // Forward: each column of `state` becomes P(state at t | examples up to t).
      for (Eigen::Index t = begin; t < end; ++t) {
        const weights predicted = t == begin
                                      ? p.mixture.priors
                                      : weights(math::product(p.transitions.transpose(), e.state.col(t - 1)));
        const weights seen = predicted.cwiseProduct(density.col(t));
        sum += math::log(math::sum(seen));
        e.state.col(t) = seen / math::sum(seen);
      }
      // Backward: `later` is proportional to P(examples after t | state at t).
      weights later = weights::Ones();
      for (Eigen::Index t = end - 1; t > begin; --t) {
        const weights from_here = density.col(t).cwiseProduct(later);
        const transition_matrix both =
            e.state.col(t - 1).asDiagonal() * p.transitions * from_here.asDiagonal();
        if (const double all = math::sum(both); all > 0) e.passages += both / all;
        later = math::product(p.transitions, from_here);
        if (const double most = later.maxCoeff(); most > 0) later /= most;
        else later.setOnes();  // no state leads to what came: then it tells nothing about this one
        const weights smoothed = e.state.col(t - 1).cwiseProduct(later);
        if (const double all = math::sum(smoothed); all > 0) e.state.col(t - 1) = smoothed / all;
      }
      e.beginnings += e.state.col(begin);
      begin = end;
    }
    return sum / static_cast<double>(points.size());
  }
};

}  // namespace cca
