// A discrete movement primitive as a component: a learned shape from where it is to a goal, in a given time.
//
//   cca::node<"reach", cca::dmp_discrete<leg_angles, 20>, cca::timed<1>>      20 basis functions
//   in  "goal"        S, any space of one number an axis; may change while it runs
//   in  "start"       S, optional: where it begins (the measured position); else the space's zero. Until a
//   first sample has
//                     come there, it waits and publishes its status alone
//   in  "duration"    movement_duration, s, optional: else the parameter; may change while it runs; at least
//   1 ms in  "restart"     restart_signal, optional: each sample that arrives begins the movement anew, from
//   where it is out "position"    S, a maybe out "velocity"    velocity_of<S>, a maybe out "progress"
//   movement_progress, a maybe: the canonical variable, from 1 to e^-decay at the end of the duration out
//   "status"      ode_status_port
//
// The weights are a parameter: one row an axis; zero makes it a critically damped spring. A restart keeps
// position and velocity. Errors: none; while an input is not finite, it stays where it is and publishes its
// status alone. Cost: four derivatives of N + 1 exponentials each. Source: dmp_discrete_ode.hpp. Example:
// tests/runtime/motor/dmp.cpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <tuple>

#include <cca/adaptive/ode_solver.hpp>
#include <cca/adaptive/ode_status.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/motor/equations/dmp_discrete_ode.hpp>
#include <cca/motor/finite.hpp>
#include <cca/motor/spaces.hpp>

namespace cca {

template <detail::LinearSpace S, int N, class Integrator = rk4>
struct dmp_discrete {
  using ode = dmp_discrete_ode<S::size, N>;
  using weight_matrix = Eigen::Matrix<double, S::size, N>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (weight_matrix, weights),
                             (cca::quantity<cca::duration, 0.001, 1000>, duration),
                             (bounded<double, 0.1, 1000>, stiffness),
                             (bounded<double, 0.1, 50>, decay),
                             (bounded<double, 0, 1000>, goal_rate),
                             (bool, scaled),
                             (ode_settling, settling));
  };
  parameters p{weight_matrix::Zero(), 1.0, 25.0, 5.0, 12.5, true, {1e-3, 1e-2}};

  auto process(in<"goal", S> goal,
               optional_in<"start", S> start,
               optional_in<"duration", movement_duration> duration,
               optional_in<"restart", restart_signal> restart,
               beat now) -> std::tuple<maybe<"position", S>,
                                       maybe<"velocity", velocity_of<S>>,
                                       maybe<"progress", movement_progress>,
                                       out<"status", ode_status_port>> {
    constexpr int D = S::size;
    using vector = typename ode::vector;
    const double wanted = duration ? duration[duration_axis{}] : p.duration.value(),
                 seconds = std::max(1e-3, wanted);
    if (!detail::all_finite(goal.vector()) || !std::isfinite(wanted) ||
        (!begun && start && !detail::has_come(start)))
      return {{}, {}, {}, status_of(status.get())};
    if (!begun) {
      from = start ? start.vector() : sample<S>{}.vector();
      solver.set(ode::at_rest(from, goal.vector()));
      begun = true;
    } else if (restart && restart.fresh()) {
      typename ode::state x = solver.get();
      from = x.template head<D>();
      x.template segment<D>(2 * D) = goal.vector();
      x[3 * D] = 1;
      solver.set(x);
    }
    const typename ode::parameters at{p.weights, p.stiffness, p.decay, p.goal_rate, p.scaled};
    typename ode::input u;
    u << goal.vector(), from, seconds;
    solver.advance(u, at, now.dt());
    const typename ode::state rate = solver.rate(u, at);
    return {vector(solver.get().template head<D>()), vector(rate.template head<D>()), solver.get()[3 * D],
            status_of(status.update(rate.norm(), p.settling))};
  }

  // Begins at "start" again.
  void on_start() {
    begun = false;
    status = {};
  }

private:
  ode_solver<ode, Integrator> solver;
  ode_monitor status;
  typename ode::vector from = ode::vector::Zero();
  bool begun = false;
};

}  // namespace cca
