// The equation of a Hopf oscillator in coordinates x, y.
//
//   x' = c (m - r^2) x - w y,  y' = c (m - r^2) y + w x      with m = A |A|, w = 2 pi f
//
// input: A (the wanted amplitude), f in Hz. Positive A: a circle of radius A attracts every state but the
// origin. Negative A: the origin attracts (a supercritical Hopf bifurcation at A = 0). Closed form, from r' =
// c (m - r^2) r (Bernoulli): r(t)^2 = m / (1 + (m / r0^2 - 1) e^(-2 c m t)); the angle advances at w.
// Source: Righetti and Ijspeert, Pattern generators with sensory feedback for the control of quadruped
// locomotion, ICRA 2008: their oscillator with alpha = beta = c; the negative amplitude: seed, section 6.3.
// Checked against the closed form: inwards, outwards, negative amplitude (tests/runtime/motor/hopf.cpp).
#pragma once

#include <cmath>
#include <numbers>

#include <cca/adaptive/ode.hpp>

namespace cca {

struct hopf_ode {
  using state = Eigen::Matrix<double, 2, 1>;
  using input = Eigen::Matrix<double, 2, 1>;
  struct parameters {
    double convergence;  // c, per s and per square of the amplitude's unit
  };

  static state derivative(const state& x, const input& u, const parameters& p) {
    const double along = p.convergence * (u[0] * std::abs(u[0]) - x.dot(x)),
                 around = 2 * std::numbers::pi * u[1];
    return {along * x[0] - around * x[1], along * x[1] + around * x[0]};
  }
};

}  // namespace cca
