// Holds the state of an ode and advances it: a model with an integrator.
//
//   cca::ode_solver<vite_ode<2>, cca::rk4> solver;
//   solver.advance(u, p, now.dt());         // in process
//
// It is a value: a copy continues independently. Precondition: dt >= 0.
//
// The state stays finite. A step that is too long for the integrator is taken in closed form if the model has
// one (`flow`), else divided into up to `most_parts` parts, if the model states its `fastest` rate. If that
// is not enough the model advances by as much time as these parts allow, so it runs slower than asked, and
// `advance` returns false. So it does for a step whose end is not finite, which is not taken: a NaN input
// leaves the state as it is. A model without `fastest` gets undivided steps: then eigenvalues of at most
// about 2 / dt are a precondition.
//
// Cost: that of the integrator; the bound, and a check that the new state is finite.
// Example: tests/runtime/ode/example.cpp.
#pragma once

#include <cmath>

#include <cca/base/math/roots.hpp>
#include <cca/component/input_status.hpp>
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

  // True if it advanced by dt, else by less. always_inline, here and below: otherwise each step is a call and
  // the state stays in memory (docs/compilers.md).
  [[gnu::always_inline]] bool advance(const input& u, const parameters& p, double dt) {
    if constexpr (requires { Model::fastest(x, u, p); }) {
      const double parts = Model::fastest(x, u, p) * dt / longest_step;
      if (!(parts <= 1)) [[unlikely]]
        return advance_in_parts(u, p, dt, parts);
    }
    return step(u, p, dt);
  }

  // The rate of change of the current state under this input.
  [[gnu::always_inline]] state rate(const input& u, const parameters& p) const {
    return Model::derivative(x, u, p);
  }

private:
  [[gnu::always_inline]] bool step(const input& u, const parameters& p, double dt) {
    state next = x;
    Integrator{}.template step<Model>(next, u, p, dt);
    return take(next);
  }

  // By value: references to what is seldom needed would keep it in memory in each beat.
  [[gnu::noinline]] bool advance_in_parts(input u, parameters p, double dt, double parts) {
    if constexpr (requires { Model::flow(x, u, p, dt); }) {
      return take(Model::flow(x, u, p, dt));
    } else {
      if (!std::isfinite(parts)) return false;
      const bool whole = parts <= most_parts;
      const int count = whole ? static_cast<int>(math::ceil(parts)) : most_parts;
      const double part = whole ? dt / count : dt / parts;
      bool taken = true;
      for (int i = 0; i < count && taken; ++i) taken = step(u, p, part);
      return whole && taken;
    }
  }

  [[gnu::always_inline]] bool take(state next) {
    if constexpr (requires { Model::project(next); }) next = Model::project(next);
    if (!detail::all_finite(next)) [[unlikely]]
      return false;
    x = next;
    return true;
  }

  state x;
};

}  // namespace cca
