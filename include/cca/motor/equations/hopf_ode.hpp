// The equation of a Hopf oscillator in coordinates x, y.
//
//   x' = c (m - r^2) x - w y,  y' = c (m - r^2) y + w x      with m = A |A|, w = 2 pi f
//
// input: A (the wanted amplitude), f in Hz. Positive A: a circle of radius A attracts every state but the
// origin. Negative A: the origin attracts (a supercritical Hopf bifurcation at A = 0). Closed form, from r' =
// c (m - r^2) r (Bernoulli): r(t)^2 = m / (1 + (m / r0^2 - 1) e^(-2 c m t)); the angle advances at w. `flow`
// is this form, written so that no term overflows: it holds for every step and every amplitude.
// Source: Righetti and Ijspeert, Pattern generators with sensory feedback for the control of quadruped
// locomotion, ICRA 2008: their oscillator with alpha = beta = c; the negative amplitude: the source document,
// section 6.3. Checked against the closed form: inwards, outwards, negative amplitude; `flow` against steps
// of rk4 (tests/runtime/motor/hopf.cpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math.hpp>
#include <cca/adaptive/ode.hpp>

namespace cca {

struct hopf_ode {
  using state = Eigen::Matrix<double, 2, 1>;
  using input = Eigen::Matrix<double, 2, 1>;
  struct parameters {
    double convergence;  // c, per s and per square of the amplitude's unit
  };

  static state derivative(const state& x, const input& u, const parameters& p) {
    const double along = p.convergence * (u[0] * std::abs(u[0]) - math::dot(x, x)),
                 around = 2 * std::numbers::pi * u[1];
    return {along * x[0] - around * x[1], along * x[1] + around * x[0]};
  }

  // On the way to a smaller circle the radius counts, to a larger one the amplitude.
  static double fastest(const state& x, const input& u, const parameters& p) {
    return 2 * p.convergence * std::max(u[0] * u[0], math::dot(x, x)) + 2 * std::numbers::pi * std::abs(u[1]);
  }

  // With s = 2 c m t: r^2 = r0^2 e^s / (1 + r0^2 2 c t (e^s - 1) / s), both parts divided by e^s if s > 0.
  static state flow(const state& x, const input& u, const parameters& p, double seconds) {
    const double s = 2 * p.convergence * u[0] * std::abs(u[0]) * seconds, falling = math::exp(-std::abs(s)),
                 share = s == 0 ? 1 : -math::expm1(-std::abs(s)) / std::abs(s);
    const double pull = math::dot(x, x) * 2 * p.convergence * seconds * share;
    if (!(pull + falling > 0)) return x;  // the origin is an equilibrium
    const double scale = math::sqrt(s > 0 ? 1 / (falling + pull) : falling / (1 + pull));
    const auto turn = math::sine_and_cosine(2 * std::numbers::pi * u[1] * seconds);
    const double along = scale * turn.cosine, around = scale * turn.sine;
    return {along * x[0] - around * x[1], along * x[1] + around * x[0]};
  }
};

}  // namespace cca
