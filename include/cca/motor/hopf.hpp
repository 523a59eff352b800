// A Hopf oscillator as a component: a running phase and an amplitude that converges to the wanted one. At a
// negative wanted amplitude the circle shrinks to the origin, so a movement that follows it comes to rest.
//
//   cca::node<"cpg", cca::hopf<stride>, cca::timed<1>>
//
//   in  "amplitude"  over<amplitude, Axis>  the wanted amplitude; negative: rest
//   in  "frequency"  over<frequency, Axis>  Hz, optional: else the parameter
//   out "phase"      over<phase, Axis>      rad in (-pi, pi]
//   out "amplitude"  over<amplitude, Axis>  the current radius
//   out "status"     ode_status_port        converged at rest; transient on the cycle, where the state moves
//
// No positive amplitude could leave the origin, which is an equilibrium. The radius is therefore kept at or
// above the parameter `ember`: a resting oscillator still has a phase, and wakes up within ln(A / ember) / (c
// A^2) s.
//
// Inputs (input_status.hpp): while one is NaN or infinite, the state stands still, phase and amplitude stay
// and the status is `unreadable`; beyond 1e12 it is cut and the status is `clamped`. Steps that are too long
// for the integrator are taken in closed form, so all parameters and amplitudes are stable at every rate.
//
// Errors: none. Cost: four derivatives, an atan2 and a square root. Source: equations/hopf_ode.hpp.
// Example: tests/runtime/motor/hopf.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <tuple>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math.hpp>
#include <cca/component/input_status.hpp>
#include <cca/adaptive/ode_solver.hpp>
#include <cca/adaptive/ode_status.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/motor/equations/hopf_ode.hpp>
#include <cca/motor/spaces.hpp>

namespace cca {

template <class Axis, class Integrator = rk4>
struct hopf {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::frequency, 0, 100>, frequency),
                             (bounded<double, 0, 1000>, convergence),
                             (bounded<double, 1e-9, 1>, ember),
                             (ode_settling, settling));
  };
  parameters p{1.0, 10.0, 1e-3, {0.05, 0.1}};

  using result = std::tuple<out<"phase", over<cca::phase, Axis>>,
                            out<"amplitude", over<cca::amplitude, Axis>>,
                            out<"status", ode_status_port>>;

  auto process(in<"amplitude", over<cca::amplitude, Axis>> wanted,
               optional_in<"frequency", over<cca::frequency, Axis>> turns,
               beat now) -> result {
    detail::input_check inputs;
    const hopf_ode::input u =
        inputs(hopf_ode::input(wanted[Axis{}], turns ? turns[Axis{}] : p.frequency.value()));
    if (inputs.unreadable())
      return published(std::max<double>(p.ember, math::norm(solver.get())), inputs.get());
    if (!solver.advance(u, {p.convergence}, now.dt())) inputs.note_clamped();
    hopf_ode::state x = solver.get();
    double radius = math::sqrt(math::dot(x, x));
    if (radius < p.ember) {
      x = radius > 0 ? hopf_ode::state(p.ember / radius * x) : hopf_ode::state(p.ember, 0);
      radius = p.ember;
      solver.set(x);
    }
    // At the radius `ember` it counts as resting, although the state still turns.
    status.update(radius > p.ember ? math::norm(solver.rate(u, {p.convergence})) : 0.0, p.settling);
    return published(radius, inputs.get());
  }

  // Begins at the radius `ember`, at rest: the status needs no reset.
  void on_start() { solver = {}; }

private:
  result published(double radius, input_status inputs) const {
    const hopf_ode::state& x = solver.get();
    return {math::atan2(x[1], x[0]), radius, status_of(inputs, status.get())};
  }

  ode_solver<hopf_ode, Integrator> solver;
  ode_monitor status;
};

}  // namespace cca
