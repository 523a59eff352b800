// The equations of N coupled phase oscillators with amplitudes.
//
//   theta_i' = 2 pi f_i + sum_j r_j w_ij sin(theta_j - theta_i - phi_ij)
//   r_i''    = a (a / 4 (R_i - r_i) - r_i')
//
// state: theta_1..N (rad), r_1..N, r'_1..N. input: f_1..N (Hz), R_1..N (wanted amplitudes). Closed forms:
// from rest r_i reaches R_i critically damped, as R_i + (r0 - R_i)(1 + a t / 2) e^(-a t / 2). Two oscillators
// of one frequency with r = 1, coupled by w both ways: D = theta_2 - theta_1 - phi_12 obeys D' = -2 w sin D,
// so tan(D/2) = tan(D0/2) e^(-2 w t). N oscillators, all coupled by w: small disturbances of the phase
// differences decay as e^(-N w t). Source: Ijspeert, Crespi, Ryczko, Cabelguen, From swimming to walking with
// a salamander robot driven by a spinal cord model, Science 315, 2007; phi_ij is the lead of j over i.
// Checked against the three closed forms (tests/runtime/motor/gait_network.cpp).
#pragma once

#include <algorithm>
#include <numbers>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math.hpp>
#include <cca/adaptive/ode.hpp>

namespace cca {

template <int N>
struct oscillator_network_ode {
  using state = Eigen::Matrix<double, 3 * N, 1>;
  using input = Eigen::Matrix<double, 2 * N, 1>;
  using matrix = Eigen::Matrix<double, N, N>;
  struct parameters {
    matrix weights = matrix::Zero();  // w_ij, per s: how strongly j pulls i; 0: not coupled
    matrix phases = matrix::Zero();   // phi_ij, rad
    double convergence = 0;           // a, per s
  };

  // Phases: the sum of a row of the Jacobian; it is N w r if all have radius r. Amplitudes: a double
  // eigenvalue -a / 2.
  static double fastest(const state& x, const input& u, const parameters& p) {
    return std::max(p.convergence / 2, p.weights.maxCoeff() * radii(x, u));
  }
  // The sum of the radii, now and where they go to.
  static double radii(const state& x, const input& u) {
    return math::sum(x.template segment<N>(N).cwiseAbs().cwiseMax(u.template tail<N>().cwiseAbs()));
  }

  static state derivative(const state& x, const input& u, const parameters& p) {
    state rate;
    for (int i = 0; i < N; ++i) {
      double drawn = 2 * std::numbers::pi * u[i];
      for (int j = 0; j < N; ++j)
        if (p.weights(i, j) != 0)
          drawn += x[N + j] * p.weights(i, j) * math::sin(x[j] - x[i] - p.phases(i, j));
      rate[i] = drawn;
      rate[N + i] = x[2 * N + i];
      rate[2 * N + i] = p.convergence * (p.convergence / 4 * (u[N + i] - x[N + i]) - x[2 * N + i]);
    }
    return rate;
  }
};

}  // namespace cca
