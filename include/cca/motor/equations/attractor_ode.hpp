// A point that follows an attractor on critically damped springs: D coordinates.
//
//   v' = az (az / 4 (g - y) - v),  y' = v
//
// state: y, v (D each). input: g (the attractor). Closed form for a constant g, from rest: g - y = (g - y0)
// (1 + l t) e^(-l t), l = az / 2. A moving attractor is followed late; `wanted_attractor` is the one that
// makes the point go through a given position with a given velocity and acceleration, so what is learned from
// a demonstration is its attractor.
// Source: Calinon, Sardellitti, Caldwell, Learning-based control strategy for safe human-robot interaction
// exploiting task and robot redundancies, IROS 2010 (virtual attractor); critical damping as in Ijspeert et
// al., Neural Computation 25, 2013, equation 2.1. Checked against the closed form
// (tests/runtime/adaptive/other_modules.cpp).
#pragma once

#include <cca/adaptive/ode.hpp>

namespace cca {

template <int D>
struct attractor_ode {
  using vector = Eigen::Matrix<double, D, 1>;
  using state = Eigen::Matrix<double, 2 * D, 1>;
  using input = vector;
  struct parameters {
    double stiffness;  // az, per s
  };
  static constexpr int positions = D;

  // A double eigenvalue -az / 2.
  static double fastest(const state&, const input&, const parameters& p) { return p.stiffness / 2; }

  static state derivative(const state& x, const input& g, const parameters& p) {
    state rate;
    rate.template head<D>() = x.template tail<D>();
    rate.template tail<D>() =
        p.stiffness * (p.stiffness / 4 * (g - x.template head<D>()) - x.template tail<D>());
    return rate;
  }

  static vector wanted_attractor(const vector& y,
                                 const vector& velocity,
                                 const vector& acceleration,
                                 const parameters& p) {
    return y + 4 / (p.stiffness * p.stiffness) * (acceleration + p.stiffness * velocity);
  }
};

}  // namespace cca
