// Least squares for models that are linear in their weights: example by example with forgetting, or in a
// batch.
//
//   k = P f / (l + f^T P f),  W += (y - W f) k^T,  P <- (P - k f^T P) / l     online; f = regressors(x),
//                                                                             P = 1 / ridge at first
//   W = (sum y f^T) P,        P = (ridge + sum f f^T)^-1                      batch: the same for l = 1
//
// It forgets only while P stays below its first value; otherwise P would wind up where the examples excite
// nothing. Trained region: f^T P f, the variance of the answer in units of the variance of an example, is at
// most `leverage`. Precondition: R <= 128 regressors (P has fixed size).
//
// Examples and inputs that are NaN or infinite don't come here (learner.hpp), so W and P stay finite.
//
// Cost: a step takes R (2 R + D) products; a batch R^2 per example and R^3.
// Source: Ljung, System Identification, second edition 1999, chapters 11 (recursion) and 7 (batch); wind-up
// of P: Astrom and Wittenmark, Adaptive Control, second edition 1995. Checked against the normal equations
// and their inverse. Example: tests/runtime/adaptive/learners.cpp.
#pragma once

#include <Eigen/Cholesky>

#include <cca/base/math/reductions.hpp>
#include <cca/adaptive/learner.hpp>
#include <cca/component/field_types.hpp>

namespace cca {

template <LinearModel Model>
struct recursive_least_squares {
  using model = Model;
  using input = typename model::input;
  using output = typename model::output;
  using parameters = typename model::parameters;
  using regressor = decltype(model::regressors(std::declval<const input&>()));
  static constexpr int size = regressor::RowsAtCompileTime;
  using covariance = Eigen::Matrix<double, size, size>;
  static constexpr std::string_view name = "recursive_least_squares";

  struct settings {
    BOOST_HANA_DEFINE_STRUCT(settings,
                             (bounded<double, 0.5, 1>, memory),
                             (bounded<double, 1e-12, 1e12>, ridge),
                             (bounded<double, 0, infinity>, leverage));
    constexpr settings(double keep = 1.0, double small = 1e-6, double most = 1.0)
        : memory(keep), ridge(small), leverage(most) {}
  };

  // `uncertainty` is P; zero means that nothing was learned.
  struct learned {
    BOOST_HANA_DEFINE_STRUCT(learned, (parameters, function), (covariance, uncertainty));
    learned() : function(), uncertainty(covariance::Zero()) {}
  };

  static bool inside(const learned& known, const input& x, const settings& s) {
    const regressor f = model::regressors(x);
    const double leverage = math::dot(f, math::product(known.uncertainty, f));
    return known.uncertainty(0, 0) > 0 && leverage <= s.leverage;
  }

  static void step(learned& known, const input& x, const output& y, const settings& s) {
    covariance& P = known.uncertainty;
    if (!(P(0, 0) > 0)) P = covariance::Identity() / s.ridge;
    const regressor f = model::regressors(x), Pf = math::product(P, f);
    const double memory = math::trace(P) < size / s.ridge ? s.memory.value() : 1.0;
    const double scale = 1 / (memory + math::dot(f, Pf));
    const output off = y - math::product(known.function.weights, f);
    known.function.weights += off * (scale * Pf).transpose();
    // Writes both halves with the same value: P stays symmetric bit for bit.
    for (int j = 0; j < size; ++j)
      for (int i = 0; i <= j; ++i) P(i, j) = P(j, i) = (P(i, j) - scale * Pf[i] * Pf[j]) / memory;
  }

  static learned batch(std::span<const example<model>> examples, const settings& s) {
    learned known;
    covariance A = s.ridge * covariance::Identity();
    Eigen::Matrix<double, size, output::RowsAtCompileTime> b =
        Eigen::Matrix<double, size, output::RowsAtCompileTime>::Zero();
    for (const auto& one : examples) {
      const regressor f = model::regressors(one.x);
      A += f * f.transpose();
      b += f * one.y.transpose();
    }
    const Eigen::LLT<covariance> factor(A);
    known.function.weights = factor.solve(b).transpose();
    const covariance inverse = factor.solve(covariance::Identity());
    known.uncertainty = (inverse + inverse.transpose()) / 2;
    return known;
  }
};

}  // namespace cca
