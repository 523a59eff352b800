// Basis functions of dynamical movement primitives: the weight of each function at a point of the movement.
//
//   discrete   Psi_i(x)   = exp(-h_i (x - c_i)^2)           c_i = e^(-a i / (N - 1)): evenly spaced in time
//                                                           h_i = 1 / (c_i - c_(i+1))^2
//   rhythmic   Psi_i(phi) = exp(h (cos(phi - c_i) - 1))     c_i = 2 pi i / N,  h = 2.5 N
//
// The functions below return the normalised activations Psi_i / sum Psi. The forcing term is their product
// with the weights. The regressors of a learner are the activations times the scale of the forcing term. Far
// from all centres, where each Psi underflows, the activations are 0. Cost: one exponential per function.
// Source: Ijspeert, Nakanishi, Hoffmann, Pastor, Schaal, Dynamical movement primitives: learning attractor
// models for motor behaviors, Neural Computation 25, 2013, equations 2.3, 2.4 (discrete), 2.6, 2.7
// (rhythmic).
#pragma once

#include <bit>
#include <cstdint>
#include <numbers>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/eigen.hpp>

namespace cca {

template <int N>
using activations = Eigen::Matrix<double, N, 1>;

namespace detail {

// e^x for -700 <= x <= 0, with a relative error of 4e-16. Plain arithmetic instead of std::exp, so compilers
// vectorise it. x = n ln 2 + r; the low bits of `shifted` hold n and are added to the exponent of e^r, which
// comes from its series.
[[gnu::always_inline]] inline double decayed(double x) {
  static_assert(__FINITE_MATH_ONLY__ == 0, "cca: -ffast-math breaks this exponential; compile without it");
  constexpr double unit_is_one = 6755399441055744.0, high = 0x1.62e42fee00000p-1,
                   low = 0x1.a39ef35793c76p-33;  // ln 2 in two parts
  const double shifted = x * std::numbers::log2e + unit_is_one, n = shifted - unit_is_one;
  const double r = x - n * high - n * low;
  const double series =
      1 +
      r * (1 + r * (1. / 2 +
                    r * (1. / 6 +
                         r * (1. / 24 +
                              r * (1. / 120 +
                                   r * (1. / 720 +
                                        r * (1. / 5040 +
                                             r * (1. / 40320 + r * (1. / 362880 +
                                                                    r * (1. / 3628800 +
                                                                         r * (1. / 39916800 +
                                                                              r * (1. / 479001600))))))))))));
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(series) +
                               (std::bit_cast<std::uint64_t>(shifted) << 52));
}

template <int N>
struct too_few_functions {
  static constexpr void tell(text& m) {
    m << "learner.model: a discrete movement primitive has " << N
      << (N == 1 ? " basis function" : " basis functions")
      << ", and it has at least two: write a larger number";
  }
};

}  // namespace detail

// `decay` is a of the canonical system: x = e^-a at the end of the movement.
template <int N>
activations<N> discrete_activations(double x, double decay) {
  static_assert(detail::holds_or_tells<(N >= 2), detail::too_few_functions<N>>::value);
  activations<N> psi;
  const double ratio = math::exp(-decay / (N - 1));
  double centre = 1;
  for (int i = 0; i < N; ++i) {
    const double off = (x - centre) / (centre * (1 - ratio));
    psi[i] = math::exp(-off * off);
    centre *= ratio;
  }
  const double sum = math::sum(psi);
  if (!(sum > 0)) return activations<N>::Zero();
  psi /= sum;
  return psi;
}

// One sine and one cosine in all: the addition theorem gives cos(phi - c_i) of the next centre.
template <int N>
[[gnu::always_inline]] inline activations<N> rhythmic_activations(double phase) {
  constexpr auto turn = math::sine_and_cosine(2 * std::numbers::pi / N);
  constexpr double turn_cos = turn.cosine, turn_sin = turn.sine;
  constexpr double least = -700;  // with more than 140 functions: negligible
  activations<N> psi;
  auto [sine, cosine] = math::sine_and_cosine(phase);
  for (int i = 0; i < N; ++i) {
    psi[i] = least > 2.5 * N * (cosine - 1) ? least : 2.5 * N * (cosine - 1);
    const double next = cosine * turn_cos + sine * turn_sin;
    sine = sine * turn_cos - cosine * turn_sin;
    cosine = next;
  }
  for (int i = 0; i < N; ++i) psi[i] = detail::decayed(psi[i]);
  psi /= math::sum(psi);
  return psi;
}

}  // namespace cca
