// The equations of a rhythmic movement primitive of D coordinates.
//
//   tau z' = az (az / 4 (g - y) - z) + f(phi, r),   tau y' = z      transformation system (2.1)
//   tau phi' = 1                                                    canonical system (2.5)
//   f(phi, r) = sum Psi_i w_i / sum Psi_i r                         forcing term (2.6, 2.7: dmp_basis.hpp)
//
// state: y, z (D each), phi in rad. input: g (the centre), r (amplitude), tau = 1 / (2 pi f) in s. The
// forcing term does not depend on y: two runs approach each other as (1 + l t) e^(-l t), l = az / (2 tau). So
// the limit cycle is the response of a linear filter to f, and at r = 0 it is the point g.
// Source: Ijspeert et al., Neural Computation 25, 2013, with the equation numbers above. Checked against the
// closed form (tests/runtime/motor/dmp.cpp).
#pragma once

#include <algorithm>

#include <cca/adaptive/ode.hpp>
#include <cca/motor/equations/dmp_basis.hpp>

namespace cca {

template <int D, int N>
struct dmp_rhythmic_ode {
  using vector = Eigen::Matrix<double, D, 1>;
  using state = Eigen::Matrix<double, 2 * D + 1, 1>;
  using input = Eigen::Matrix<double, D + 2, 1>;
  struct parameters {
    const Eigen::Matrix<double, D, N>& weights;  // a reference: no copy in each beat
    double stiffness;                            // az
  };
  static constexpr int positions = D;

  // The transformation system has a double eigenvalue -az / 2.
  static double fastest(const state&, const input& u, const parameters& p) {
    return std::max(p.stiffness / 2, 1.0) / u[D + 1];
  }

  // always_inline: otherwise four calls in each step of rk4 (docs/compilers.md).
  [[gnu::always_inline]] static state derivative(const state& s, const input& u, const parameters& p) {
    const vector y = s.template head<D>(), z = s.template segment<D>(D);
    const activations<N> near = rhythmic_activations<N>(s[2 * D]);
    vector forcing = vector::Zero();
    for (int i = 0; i < N; ++i) forcing += near[i] * p.weights.col(i);
    forcing *= u[D];
    state rate;
    rate.template head<D>() = z;
    rate.template segment<D>(D) = p.stiffness * (p.stiffness / 4 * (u.template head<D>() - y) - z) + forcing;
    rate[2 * D] = 1;
    return rate / u[D + 1];
  }

  // The forcing term that reproduces a demonstration at one time (2.12).
  static vector wanted_forcing(const vector& y,
                               const vector& velocity,
                               const vector& acceleration,
                               const vector& goal,
                               double tau,
                               const parameters& p) {
    return tau * tau * acceleration - p.stiffness * (p.stiffness / 4 * (goal - y) - tau * velocity);
  }
};

}  // namespace cca
