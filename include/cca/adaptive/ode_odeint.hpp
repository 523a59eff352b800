// Steppers of Boost.Numeric.Odeint as integrators.
//
//   #include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
//   #include <boost/numeric/odeint/algebra/vector_space_algebra.hpp>
//   template <class State>
//   using dopri5 = boost::numeric::odeint::runge_kutta_dopri5<State, double, State, double,
//                                                             boost::numeric::odeint::vector_space_algebra>;
//   cca::ode_solver<decay, cca::odeint<dopri5>> solver;
//
// This header does not include Boost: the user chooses the stepper, over `vector_space_algebra`. Each step
// makes a new stepper, so a beat depends only on the state. That allows one-step steppers (runge_kutta4,
// cash_karp54, dopri5, fehlberg78, modified_midpoint), not those that use earlier steps. The step is the
// beat; its length is not adapted. Cost: that of the stepper; no allocation, since states have fixed size.
//
// While an input is NaN or infinite: a step whose end is not finite is dropped by the solver, which keeps its
// state and says so by the result of `advance` (ode_solver.hpp). No stepper keeps anything of it.
// Example: tests/runtime/ode/odeint.cpp.
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
