// Integrators: how an ode advances by one step. An integrator is a policy: `step<Model>(x, u, p, dt)` changes
// x to the state dt seconds later, with the input held.
//
//   explicit_euler        order 1; one derivative per step
//   semi_implicit_euler   order 1; for second-order systems: first the velocities, then the positions from
//                         the new velocities. Undamped oscillations neither gain nor lose energy
//                         (symplectic). Two derivatives per step, of which half is used each
//   rk4                   order 4; four derivatives
//   odeint<...>           any one-step stepper of Boost.Numeric.Odeint (ode_odeint.hpp)
//
// All are explicit: a step is stable only while rate * dt is small. `longest_step` is the bound that the
// solver uses, 1 for all of them: well inside the region of stability (explicit Euler 2, rk4 2.78 on the real
// axis), so that the steps are accurate, too.
//
// Sources: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 1993, section II.1 (rk4);
// Hairer, Lubich, Wanner, Geometric Numerical Integration, 2006, section I.1 (symplectic Euler). Checked:
// orders against closed forms, energy of the symplectic method, Odeint's classical method to rounding
// (tests/runtime/ode).
#pragma once

#include <cca/adaptive/ode.hpp>

namespace cca {

inline constexpr double longest_step = 1;  // rate * dt
inline constexpr int most_parts = 16;      // into which the solver divides a step

struct explicit_euler {
  static constexpr int order = 1;
  // always_inline, here and below: otherwise each step is a call and the state stays in memory
  // (docs/compilers.md).
  template <Ode Model>
  [[gnu::always_inline]] static void step(ode_state<Model>& x,
                                          const ode_input<Model>& u,
                                          const typename Model::parameters& p,
                                          double dt) {
    const ode_state<Model> rate = Model::derivative(x, u, p);
    x += dt * rate;
  }
};

struct semi_implicit_euler {
  static constexpr int order = 1;
  template <SecondOrderOde Model>
  [[gnu::always_inline]] static void step(ode_state<Model>& x,
                                          const ode_input<Model>& u,
                                          const typename Model::parameters& p,
                                          double dt) {
    constexpr int positions = Model::positions, others = ode_state<Model>::RowsAtCompileTime - positions;
    const ode_state<Model> before = Model::derivative(x, u, p);
    x.template tail<others>() += dt * before.template tail<others>();
    const ode_state<Model> after = Model::derivative(x, u, p);
    x.template head<positions>() += dt * after.template head<positions>();
  }
};

struct rk4 {
  static constexpr int order = 4;
  template <Ode Model>
  [[gnu::always_inline]] static void step(ode_state<Model>& x,
                                          const ode_input<Model>& u,
                                          const typename Model::parameters& p,
                                          double dt) {
    using vector = ode_state<Model>;
    const vector k1 = Model::derivative(x, u, p);
    const vector k2 = Model::derivative(vector(x + dt / 2 * k1), u, p);
    const vector k3 = Model::derivative(vector(x + dt / 2 * k2), u, p);
    const vector k4 = Model::derivative(vector(x + dt * k3), u, p);
    x += dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
};

template <class Type, class Model> concept IntegratorOf =
    requires(Type integrator,
             ode_state<Model>& x,
             const ode_input<Model>& u,
             const typename Model::parameters& p,
             double dt) { integrator.template step<Model>(x, u, p, dt); };

}  // namespace cca
