// Basis functions of dynamical movement primitives: how much each weight counts at a point of the movement.
//
//   discrete   Psi_i(x)   = exp(-h_i (x - c_i)^2), c_i = e^(-a i / (N - 1)): evenly spaced in time; h_i = 1 / (c_i - c_(i+1))^2
//   rhythmic   Psi_i(phi) = exp(h (cos(phi - c_i) - 1)), c_i = 2 pi i / N; h = 2.5 N
//
// `activations` are Psi_i / sum Psi; the forcing term is their product with the weights. A learner's regressors are these
// times what scales the forcing term. Far from all centres, where the Psi are too small for a double, they are 0.
// Cost: an exponential a function. Source: Ijspeert, Nakanishi, Hoffmann, Pastor, Schaal, Dynamical movement primitives: learning
// attractor models for motor behaviors, Neural Computation 25, 2013, equations 2.3, 2.4 (discrete), 2.6, 2.7 (rhythmic).
#pragma once

#include <cmath>
#include <numbers>

#include <cca/space/eigen.hpp>

namespace cca {

template <int N>
using activations = Eigen::Matrix<double, N, 1>;

namespace detail {

template <int N>
activations<N> normalised(activations<N> psi) {
  const double sum = psi.sum();
  return sum > 0 ? activations<N>(psi / sum) : activations<N>(activations<N>::Zero());
}

}  // namespace detail

// `decay` is a, of the canonical system: x = e^-a at the end of the movement.
template <int N>
activations<N> discrete_activations(double x, double decay) {
  static_assert(N >= 2, "a discrete movement primitive has at least two basis functions");
  activations<N> psi;
  const double ratio = std::exp(-decay / (N - 1));
  double centre = 1;
  for (int i = 0; i < N; ++i) {
    const double off = (x - centre) / (centre * (1 - ratio));
    psi[i] = std::exp(-off * off);
    centre *= ratio;
  }
  return detail::normalised<N>(psi);
}

// A function of its own: in the middle of a beat g++ would reload all that it needs after each of its calls, twice the instructions.
template <int N>
[[gnu::noinline]] activations<N> rhythmic_activations(double phase) {
  activations<N> psi;
  for (int i = 0; i < N; ++i) psi[i] = std::exp(2.5 * N * (std::cos(phase - 2 * std::numbers::pi * i / N) - 1));
  return detail::normalised<N>(psi);
}

}  // namespace cca
