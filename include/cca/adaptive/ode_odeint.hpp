// Boost.Numeric.Odeint's steppers as integrators.
//
//   #include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
//   #include <boost/numeric/odeint/algebra/vector_space_algebra.hpp>
//   template <class State>
//   using dopri5 = boost::numeric::odeint::runge_kutta_dopri5<State, double, State, double,
//   boost::numeric::odeint::vector_space_algebra>; cca::ode_solver<decay, cca::odeint<dopri5>> solver;
//
// This header needs nothing of Boost: the stepper is the user's, over `vector_space_algebra`. It is made anew
// in each step, so that a beat depends on the state alone: one-step steppers only (runge_kutta4, cash_karp54,
// dopri5, fehlberg78, modified_midpoint), none that remembers earlier steps. The step's length is the beat's:
// none is adapted. Cost: that of the stepper; nothing allocates, since the states are of fixed size. Example:
// tests/runtime/ode/odeint.cpp.
#pragma once

#include <cca/adaptive/numerics/ode_integrators.hpp>

namespace cca {

template <template <class State> class Stepper>
struct odeint {
  template <Ode Model>
  static void step(ode_state<Model>& x,
                   const ode_input<Model>& u,
                   const typename Model::parameters& p,
                   double dt) {
    using vector = ode_state<Model>;
    Stepper<vector> stepper;
    stepper.do_step([&](const vector& at, vector& rate, double) { rate = Model::derivative(at, u, p); }, x,
                    0.0, dt);
  }
};

}  // namespace cca
