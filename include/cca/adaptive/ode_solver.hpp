// Holds the state of an ode and advances it: a model with an integrator.
//
//   cca::ode_solver<vite_ode<2>, cca::rk4> solver;
//   solver.advance(u, p, now.dt());         // in process
//
// It is a value: a copy continues independently. Preconditions: dt >= 0; the step is short enough for the
// integrator (explicit methods: eigenvalues of at most about 2 / dt). Example: tests/runtime/ode/example.cpp.
#pragma once

#include <cca/adaptive/numerics/ode_integrators.hpp>

namespace cca {

template <Ode Model, class Integrator = rk4>
  requires IntegratorOf<Integrator, Model>
class ode_solver {
public:
  using state = ode_state<Model>;
  using input = ode_input<Model>;
  using parameters = typename Model::parameters;

  ode_solver() : x(initial_state<Model>()) {}
  explicit ode_solver(const state& from) : x(from) {}

  const state& get() const { return x; }
  void set(const state& to) { x = to; }

  // always_inline, here and below: without it clang calls each step and keeps the state in memory.
  [[gnu::always_inline]] void advance(const input& u, const parameters& p, double dt) {
    Integrator{}.template step<Model>(x, u, p, dt);
    if constexpr (requires { Model::project(x); }) x = Model::project(x);
  }

  // The rate of change of the current state under this input.
  [[gnu::always_inline]] state rate(const input& u, const parameters& p) const {
    return Model::derivative(x, u, p);
  }

private:
  state x;
};

}  // namespace cca
