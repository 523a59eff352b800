// A Hopf oscillator as a component: a phase that runs, and an amplitude that comes to what is wanted. Where a
// negative one is wanted the circle shrinks to the origin, a stable fixed point: what follows it comes to
// rest.
//
//   cca::node<"cpg", cca::hopf<stride>, cca::timed<1>>
//   in  "amplitude"   over<amplitude, Axis>; negative: rest
//   in  "frequency"   over<frequency, Axis>, Hz, optional: else the parameter
//   out "phase"       over<phase, Axis>, rad in (-pi, pi]
//   out "amplitude"   over<amplitude, Axis>, the radius now
//   out "status"      ode_status_port: converged at rest, transient on the cycle, whose point moves
//
// The origin is an equilibrium that no positive amplitude would leave: the radius is held at `ember` or
// above, so a resting oscillator still has a phase and wakes up, in ln(A / ember) / (c A^2) s. Errors: none;
// while an input is not finite, it stays where it is. Cost: four derivatives, an atan2 and a root. Source:
// hopf_ode.hpp. Example: tests/runtime/motor/hopf.cpp.
#pragma once

#include <cmath>
#include <tuple>

#include <cca/adaptive/ode_solver.hpp>
#include <cca/adaptive/ode_status.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/motor/finite.hpp>
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

  auto process(in<"amplitude", over<cca::amplitude, Axis>> wanted,
               optional_in<"frequency", over<cca::frequency, Axis>> turns,
               beat now) -> std::tuple<out<"phase", over<cca::phase, Axis>>,
                                       out<"amplitude", over<cca::amplitude, Axis>>,
                                       out<"status", ode_status_port>> {
    const hopf_ode::input u(wanted[Axis{}], turns ? turns[Axis{}] : p.frequency.value());
    if (detail::all_finite(u)) solver.advance(u, {p.convergence}, now.dt());
    hopf_ode::state x = solver.get();
    double radius = std::sqrt(x.dot(x));
    if (radius < p.ember) {
      x = radius > 0 ? hopf_ode::state(p.ember / radius * x) : hopf_ode::state(p.ember, 0);
      radius = p.ember;
      solver.set(x);
    }
    // At the ember it rests, though the point goes round.
    const double rate = radius > p.ember ? solver.rate(u, {p.convergence}).norm() : 0.0;
    return {std::atan2(x[1], x[0]), radius, status_of(status.update(rate, p.settling))};
  }

  // Starts again, from the ember, where it rests: so its status needs no start.
  void on_start() { solver = {}; }

private:
  ode_solver<hopf_ode, Integrator> solver;
  ode_monitor status;
};

}  // namespace cca
