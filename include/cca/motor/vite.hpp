// VITE as a component: moves from a start to a target with a bell-shaped velocity.
//
//   cca::node<"reach", cca::vite<leg_angles>, cca::timed<1>>
//
//   in  "target"    S                         any space with one number per axis
//   in  "start"     S                         optional: where it begins (the measured position); else zero
//   in  "go"        over<amplitude, go_axis>  optional: a factor on the speed, at least 0; 0 holds still
//   out "position"  S                         maybe
//   out "velocity"  velocity_of<S>            maybe; unit of S per s
//   out "status"    ode_status_port           converged after arrival
//
// The clock of the GO signal restarts when a target changes after arrival. A target that changes during the
// movement is followed without a jump of the velocity. If "start" is wired, the component waits for its first
// sample and publishes only its status until then. Parameters: `convergence` a (1/s), `speed` G0 (1/s),
// `rise` b (s), `exponent` n. With the defaults 99 % of the way takes 0.96 s.
//
// Inputs (input_status.hpp): while one is NaN or infinite, the movement stands still, the velocity is 0,
// nothing else is published, and the status is `unreadable`; beyond 1e12, and a "go" below 0, it is cut and
// the status is `clamped`. A movement that is too fast for the rate of the node (max(a, sqrt(a G)) above 16 /
// dt) runs as fast as the rate allows, with the status `clamped`.
//
// Errors: none. Cost: four derivatives; up to 16 times as much while max(a, sqrt(a G)) * dt > 1.
// Source: equations/vite_ode.hpp. Example: tests/runtime/motor/vite.cpp.
#pragma once

#include <string>
#include <tuple>

#include <cca/base/math/reductions.hpp>
#include <cca/component/input_status.hpp>
#include <cca/adaptive/ode_solver.hpp>
#include <cca/adaptive/ode_status.hpp>
#include <cca/adaptive/numerics/rate_bound.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/motor/spaces.hpp>
#include <cca/motor/equations/vite_ode.hpp>

namespace cca {

struct go_axis : dimension<"go"> {};

template <detail::LinearSpace S, class Integrator = rk4>
struct vite {
  using ode = vite_ode<S::size>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (bounded<double, 0, 1000>, convergence),
                             (bounded<double, 0, 1000>, speed),
                             (cca::quantity<cca::duration, 0, 100>, rise),
                             (bounded<int, 1, 8>, exponent),
                             (ode_settling, settling));
    // With "go" at 1.
    std::string check_at(double step) const {
      const double most = detail::rate_bound(step);
      const auto text = detail::above_rate_bound("convergence", convergence, most, step);
      return text.empty() && convergence > 0
                 ? detail::above_rate_bound("speed", speed, most * most / convergence, step)
                 : text;
    }
  };
  parameters p{30.0, 7.5, 0.4, 2, {1e-3, 1e-2}};

  auto process(in<"target", S> target,
               optional_in<"start", S> start,
               optional_in<"go", over<cca::amplitude, go_axis>> go,
               beat now)
      -> std::tuple<maybe<"position", S>, maybe<"velocity", velocity_of<S>>, out<"status", ode_status_port>> {
    constexpr int D = S::size;
    detail::input_check inputs;
    typename ode::input u;
    u.template head<D>() = inputs(target.vector());
    u[D] = p.speed * (go ? inputs.number(go[go_axis{}], 0, largest_input) : 1.0);
    if (inputs.unreadable() || (!begun && start && !detail::has_come(start))) {
      maybe<"velocity", velocity_of<S>> still;
      if (begun) still = Eigen::Matrix<double, D, 1>::Zero().eval();
      return {{}, still, status_of(inputs.get(), status.get())};
    }
    typename ode::state x = solver.get();
    if (!begun) {
      x.setZero();
      if (start) x.template head<D>() = inputs(start.vector());
      else x.template head<D>() = sample<S>{}.vector();
      begun = true;
    }
    const typename ode::parameters at{p.convergence, p.rise, p.exponent};
    const bool rested = status.get() == ode_status::converged;
    if (rested && status.update(rate(x, u, at), p.settling) == ode_status::transient) x[2 * D] = 0;
    solver.set(x);
    if (!solver.advance(u, at, now.dt())) inputs.note_clamped();
    x = solver.get();
    const typename ode::state moving = solver.rate(u, at);
    return {x.template head<D>().eval(), moving.template head<D>().eval(),
            status_of(inputs.get(), status.update(rate(x, u, at), p.settling))};
  }

  // The next movement begins at "start".
  void on_start() {
    begun = false;
    status = {};
  }

private:
  // Of position and difference vector only: the clock never stops.
  static double rate(const typename ode::state& x,
                     const typename ode::input& u,
                     const typename ode::parameters& at) {
    return math::norm(ode::derivative(x, u, at).template head<2 * S::size>());
  }

  ode_solver<ode, Integrator> solver;
  ode_monitor status;
  bool begun = false;
};

}  // namespace cca
