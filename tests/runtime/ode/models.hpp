// Small equations with closed forms.
#pragma once

#include <cmath>
#include <utility>

#include <cca/adaptive/ode.hpp>

#include "../../laws/ode_laws.hpp"

namespace ode_test {

using number = Eigen::Matrix<double, 1, 1>;

// [ode]
// x' = a (u - x): from x0 it converges to u as u + (x0 - u) e^(-a t).
struct decay {
  using state = Eigen::Matrix<double, 1, 1>;
  using input = Eigen::Matrix<double, 1, 1>;
  struct parameters {
    double rate;
  };
  static state derivative(const state& x, const input& u, const parameters& p) { return p.rate * (u - x); }
};
// [ode end]

// q' = v, v' = w^2 (u - q): oscillates about u with angular frequency w.
struct oscillator {
  using state = Eigen::Vector2d;
  using input = number;
  struct parameters {
    double w;
  };
  static constexpr int positions = 1;
  static state derivative(const state& x, const input& u, const parameters& p) {
    return {x[1], p.w * p.w * (u[0] - x[0])};
  }
  static state exact(const state& x, double w, double t) {
    return {x[0] * std::cos(w * t) + x[1] / w * std::sin(w * t),
            -w * x[0] * std::sin(w * t) + x[1] * std::cos(w * t)};
  }
};

struct decay_case {
  using ode = decay;
  static constexpr double rate = 3;
  static decay::parameters parameters() { return {3}; }
  static auto state(laws::ode_source& random) { return random.vector<number>(-2, 2); }
  static auto input(laws::ode_source& random) { return random.vector<number>(-2, 2); }
  static auto equilibrium(laws::ode_source& random) {
    const auto u = input(random);
    return std::pair(u, u);
  }
};

struct oscillator_case {
  using ode = oscillator;
  static constexpr double rate = 5;
  static oscillator::parameters parameters() { return {5}; }
  static auto state(laws::ode_source& random) { return random.vector<Eigen::Vector2d>(-2, 2); }
  static auto input(laws::ode_source& random) { return random.vector<number>(-2, 2); }
  static auto equilibrium(laws::ode_source& random) {
    const auto u = input(random);
    return std::pair(Eigen::Vector2d(u[0], 0), u);
  }
};

}  // namespace ode_test
