// The laws of an Ode, stated once and run for every model.
//
// A case has `Case::ode`; `Case::state(source)` and `Case::input(source)`, random values of its intended
// range; `Case::parameters()`; `Case::rate`, an upper bound of its rates of decay and rotation, per s; and,
// if it has one, `Case::equilibrium(source)`, a state and an input under which it rests.
// `laws::allocations()` counts calls of malloc; the test program defines it.
#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>

#include <doctest/doctest.h>

#include <cca/adaptive/ode_solver.hpp>

#include "law.hpp"

namespace laws {

std::size_t allocations();

struct ode_source {
  std::mt19937_64 bits;
  double operator()(double from, double to) {
    return from + (to - from) * static_cast<double>(bits() >> 11) * 0x1p-53;
  }
  template <class Vector>
  Vector vector(double from, double to) {
    Vector v;
    for (int i = 0; i < v.size(); ++i) v[i] = (*this)(from, to);
    return v;
  }
};

template <class Case, class Integrator>
auto after(const cca::ode_state<typename Case::ode>& x,
           const cca::ode_input<typename Case::ode>& u,
           double seconds,
           int steps) {
  const auto p = Case::parameters();
  cca::ode_solver<typename Case::ode, Integrator> solver(x);
  for (int i = 0; i < steps; ++i) solver.advance(u, p, seconds / steps);
  return solver.get();
}

// From any state and input it is finite after a second; the same start gives the same end, bit for bit;
// nothing allocates.
template <class Case, class Integrator>
void runs() {
  ode_source random{std::mt19937_64{1}};
  for (int i = 0; i < 20; ++i) {
    const auto x = Case::state(random);
    const auto u = Case::input(random);
    const std::size_t before = allocations();
    const auto end = after<Case, Integrator>(x, u, 1.0, 1000);
    const auto again = after<Case, Integrator>(x, u, 1.0, 1000);
    const std::size_t allocated = allocations() - before;
    CHECK_MESSAGE(end.allFinite(), "finite");
    CHECK_MESSAGE(end == again, "deterministic");
    CHECK_MESSAGE(allocated == 0, "nothing allocates");
  }
}

// A step of zero length changes nothing; a short step moves along the derivative.
template <class Case, class Integrator>
void follows_the_derivative() {
  ode_source random{std::mt19937_64{2}};
  const auto p = Case::parameters();
  const double dt = 1e-5 / Case::rate;
  for (int i = 0; i < 20; ++i) {
    const auto u = Case::input(random);
    const auto x = after<Case, Integrator>(Case::state(random), u, 0.0, 1);  // projected
    CHECK_MESSAGE((after<Case, Integrator>(x, u, 0.0, 1) - x).norm() <= 1e-15 * x.norm(),
                  "a step of zero length changes nothing");
    const auto rate = Case::ode::derivative(x, u, p);
    const auto moved = ((after<Case, Integrator>(x, u, dt, 1) - x) / dt).eval();
    CHECK_MESSAGE((moved - rate).norm() <= 1e-3 * (1 + rate.norm() + Case::rate * x.norm()),
                  "a short step moves along the derivative");
  }
}

// Half the step divides the error by 2^order: measured by the changes from one halving to the next, over
// random starts together.
template <class Case, class Integrator>
void order(int expected) {
  ode_source random{std::mt19937_64{3}};
  double first = 0, second = 0;
  for (int i = 0; i < 10; ++i) {
    const auto x = Case::state(random);
    const auto u = Case::input(random);
    const double seconds = 1 / Case::rate;
    const int steps = expected == 1 ? 128 : 16;
    const auto a = after<Case, Integrator>(x, u, seconds, steps),
               b = after<Case, Integrator>(x, u, seconds, 2 * steps),
               c = after<Case, Integrator>(x, u, seconds, 4 * steps);
    first += (a - b).norm();
    second += (b - c).norm();
  }
  const double seen = std::log2(first / second);
  CHECK_MESSAGE(seen > expected - 0.25, "order " << seen << ", not " << expected);
}

// Where the derivative is zero it stays for a second.
template <class Case, class Integrator>
void rests() {
  ode_source random{std::mt19937_64{4}};
  const auto p = Case::parameters();
  for (int i = 0; i < 20; ++i) {
    const auto [x, u] = Case::equilibrium(random);
    CHECK_MESSAGE(Case::ode::derivative(x, u, p).norm() < 1e-9, "an equilibrium");
    CHECK_MESSAGE((after<Case, Integrator>(x, u, 1.0, 1000) - x).norm() < 1e-9, "it stays there");
  }
}

template <class Case, class Integrator>
void ode_with(int expected_order) {
  law("stays finite, the same each time", runs<Case, Integrator>);
  law("follows its derivative", follows_the_derivative<Case, Integrator>);
  law("has its order", [&] { order<Case, Integrator>(expected_order); });
  ode_source any{std::mt19937_64{5}};
  if constexpr (requires { Case::equilibrium(any); })
    law("rests in its equilibrium", rests<Case, Integrator>);
}

// All laws, with each integrator that fits.
template <class Case>
void ode() {
  static_assert(cca::Ode<typename Case::ode>);
  ode_with<Case, cca::explicit_euler>(1);
  ode_with<Case, cca::rk4>(4);
  if constexpr (cca::SecondOrderOde<typename Case::ode>) ode_with<Case, cca::semi_implicit_euler>(1);
}

}  // namespace laws
