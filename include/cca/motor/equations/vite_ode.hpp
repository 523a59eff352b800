// The equations of VITE (vector integration to endpoint): a straight reach with a bell-shaped velocity.
//
//   V' = a (T - P - V)        difference vector, smoothed
//   P' = G(t) V               present position
//   G(t) = G0 t^n / (b^n + t^n)   GO signal, t since the movement began
//
// state: P, V (D numbers each), t in s. input: T (the target), G0 in 1/s. Negative components of V are kept:
// each coordinate stands for a pair of antagonists. Everything is linear in T - P, so coordinates move in
// step and a longer way takes the same time (synergy, isochrony); a larger G0 is faster. Closed form for G =
// G0 at once (b = 0) and a = 4 G0 (critical damping), from rest at distance D: T - P = D (1 + l t) e^(-l t)
// with l = a / 2; the speed D l^2 t e^(-l t) has its peak at 1 / l. A smaller a overshoots. Source: Bullock
// and Grossberg, Neural dynamics of planned arm movements: emergent invariants and speed-accuracy properties
// during trajectory formation, Psychological Review 95, 1988 (equations of the VITE circuit: difference
// vector, present position, sigmoid GO signal). Checked against the closed form and a reference integration
// with the rising GO signal (tests/runtime/motor/vite.cpp).
#pragma once

#include <algorithm>
#include <cmath>

#include <cca/adaptive/ode.hpp>
#include <cca/base/math/roots.hpp>

namespace cca {

template <int D>
struct vite_ode {
  using state = Eigen::Matrix<double, 2 * D + 1, 1>;
  using input = Eigen::Matrix<double, D + 1, 1>;
  struct parameters {
    double convergence;  // a, per s
    double rise;         // b, s: when the GO signal reaches half
    int exponent;        // n: how steeply it rises
  };
  static constexpr int positions = D;

  static double go(double t, const parameters& p) {
    if (!(p.rise > 0)) return 1;
    if (!(t > 0)) return 0;
    double ratio = 1;
    for (int i = 0; i < p.exponent; ++i) ratio *= p.rise / t;
    return 1 / (1 + ratio);
  }

  // The eigenvalues l of the movement obey l^2 + a l + a G = 0.
  static double fastest(const state&, const input& u, const parameters& p) {
    return std::max(p.convergence, math::sqrt(p.convergence * std::abs(u[D])));
  }

  static state derivative(const state& x, const input& u, const parameters& p) {
    state rate;
    rate.template head<D>() = u[D] * go(x[2 * D], p) * x.template segment<D>(D);
    rate.template segment<D>(D) =
        p.convergence * (u.template head<D>() - x.template head<D>() - x.template segment<D>(D));
    rate[2 * D] = 1;
    return rate;
  }
};

}  // namespace cca
