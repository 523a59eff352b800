// The equations of a discrete movement primitive: D coordinates that share one canonical system.
//
//   tau z' = az (az / 4 (g - y) - z) + f(x),  tau y' = z    transformation system (2.1), critically damped
//   tau x' = -ax x                                          canonical system (2.2), from 1
//   f(x) = sum Psi_i w_i / sum Psi_i x (g - y0)             forcing term (2.3, 2.4: dmp_basis.hpp)
//   tau g' = ag (goal - g)                                  smooths a goal that jumps
//
// state: y, z, g (D each), x. input: goal, y0 (where the movement began; D each), tau (the duration in s).
// Without scaling the weights are in units of y, and a movement may end where it began. A change of tau
// changes the speed from there on, not the shape; a change of the goal bends the rest of the movement. Closed
// form without forcing term, from rest, with g = goal: g - y = (g - y0)(1 + l t) e^(-l t), l = az / (2 tau).
// Source: Ijspeert et al., Neural Computation 25, 2013, with the equation numbers above; the moving goal:
// section 2.1. Checked against the closed form and a fitted minimum jerk (tests/runtime/motor/dmp.cpp).
#pragma once

#include <algorithm>
#include <cmath>

#include <cca/base/math/reductions.hpp>
#include <cca/adaptive/ode.hpp>
#include <cca/motor/equations/dmp_basis.hpp>

namespace cca {

template <int D, int N>
struct dmp_discrete_ode {
  using vector = Eigen::Matrix<double, D, 1>;
  using state = Eigen::Matrix<double, 3 * D + 1, 1>;
  using input = Eigen::Matrix<double, 2 * D + 1, 1>;
  struct parameters {
    Eigen::Matrix<double, D, N> weights;
    double stiffness;  // az
    double decay;      // ax
    double goal_rate;  // ag
    bool scaled;       // the forcing term is scaled by g - y0
  };
  static constexpr int positions = D;

  static state initial() { return at_rest(vector::Zero(), vector::Zero()); }
  static state at_rest(const vector& y, const vector& goal) {
    state x;
    x << y, vector::Zero(), goal, 1.0;
    return x;
  }

  // The scale of the forcing term.
  static vector scale(const vector& g, const vector& y0, const parameters& p) {
    return p.scaled ? vector(g - y0) : vector(vector::Ones());
  }

  static vector way(const vector& from, const vector& to) { return to - from; }

  // The transformation system has a double eigenvalue -az / 2.
  static double fastest(const state&, const input& u, const parameters& p) {
    return std::max({p.stiffness / 2, p.goal_rate, p.decay}) / u[2 * D];
  }

  static state derivative(const state& s, const input& u, const parameters& p) {
    const vector y = s.template head<D>(), z = s.template segment<D>(D), g = s.template segment<D>(2 * D);
    const double x = s[3 * D], tau = u[2 * D];
    const vector shape = math::product(p.weights, discrete_activations<N>(x, p.decay));
    const vector forcing = x * shape.cwiseProduct(scale(g, u.template segment<D>(D), p));
    state rate;
    rate.template head<D>() = z;
    rate.template segment<D>(D) = p.stiffness * (p.stiffness / 4 * (g - y) - z) + forcing;
    rate.template segment<D>(2 * D) = p.goal_rate * (u.template head<D>() - g);
    rate[3 * D] = -p.decay * x;
    return rate / tau;
  }

  // The forcing term that reproduces a demonstration (2.12), from its position, velocity and acceleration at
  // one time; the goal is its last position.
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
