// A discrete movement primitive as a component: a learned movement from a start to a goal in a given time.
//
//   cca::node<"reach", cca::dmp_discrete<leg_angles, 20>, cca::timed<1>>      20 basis functions
//
//   in  "goal"       S                  where the movement ends; may change during the movement
//   in  "start"      S                  optional: where it begins (the measured position); else the zero of S
//   in  "duration"   movement_duration  s, optional: else the parameter; at least 1 ms; may change
//   in  "restart"    restart_signal     optional: each sample restarts the movement at the current position
//   out "position"   S                  maybe
//   out "velocity"   velocity_of<S>     maybe; unit of S per s
//   out "progress"   movement_progress  maybe; the canonical variable: 1 at the start, e^-decay at the end
//   out "status"     ode_status_port
//
// S is any space with one number per axis. The parameter `weights` has one row per axis. With zero weights
// the movement is a critically damped spring. A restart keeps position and velocity. If "start" is wired, the
// component waits for its first sample and publishes only its status until then.
//
// Inputs (input_status.hpp): while one is NaN or infinite, the movement stands still, the velocity is 0,
// nothing else is published, and the status is `unreadable`; beyond 1e12, and a duration below 1 ms, it is
// cut and the status is `clamped`. A movement that is too fast for the rate of the node (duration below
// max(stiffness / 2, goal_rate, decay) * dt / 16) runs as fast as the rate allows, with the status `clamped`.
//
// Errors: none. Cost: four derivatives of N + 1 exponentials each; up to 16 times as much while
// max(stiffness / 2, goal_rate, decay) * dt > duration. Source: equations/dmp_discrete_ode.hpp.
// Example: tests/runtime/motor/dmp.cpp.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <tuple>

#include <cca/base/math/reductions.hpp>
#include <cca/component/input_status.hpp>
#include <cca/adaptive/ode_solver.hpp>
#include <cca/adaptive/ode_status.hpp>
#include <cca/adaptive/numerics/rate_bound.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/motor/equations/dmp_discrete_ode.hpp>
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
    parameters(const weight_matrix& shape = weight_matrix::Zero(),
               double seconds = 1,
               double stiff = 25,
               double decays = 5,
               double goal_follows = 12.5,
               bool scales = true,
               const ode_settling& settles = {1e-3, 1e-2})
        : weights(shape),
          duration(seconds),
          stiffness(stiff),
          decay(decays),
          goal_rate(goal_follows),
          scaled(scales),
          settling(settles) {}
    std::string_view check() const { return detail::too_large(weights, "a weight is above 1e12"); }
    std::string check_at(double step) const {
      return detail::below_rate_bound(
          "duration", duration,
          std::max({stiffness / 2, goal_rate.value(), decay.value()}) / detail::rate_bound(step), step);
    }
  };
  parameters p{};

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
    detail::input_check inputs;
    const vector to = inputs(goal.vector());
    const double seconds =
        inputs.number(duration ? duration[duration_axis{}] : p.duration.value(), 1e-3, largest_input);
    maybe<"velocity", velocity_of<S>> still;
    if (begun) still = vector(vector::Zero());
    if (inputs.unreadable() || (!begun && start && !detail::has_come(start)))
      return {{}, still, {}, status_of(inputs.get(), status.get())};
    if (!begun) {
      from = start ? inputs(start.vector()) : vector(sample<S>{}.vector());
      solver.set(ode::at_rest(from, to));
      begun = true;
    } else if (restart && restart.fresh()) {
      typename ode::state x = solver.get();
      from = inputs(x.template head<D>());
      x.template segment<D>(2 * D) = to;
      x[3 * D] = 1;
      solver.set(x);
    }
    const typename ode::parameters at{p.weights, p.stiffness, p.decay, p.goal_rate, p.scaled};
    typename ode::input u;
    u << to, from, seconds;
    if (!solver.advance(u, at, now.dt())) inputs.note_clamped();
    const typename ode::state rate = solver.rate(u, at);
    return {vector(solver.get().template head<D>()), vector(rate.template head<D>()), solver.get()[3 * D],
            status_of(inputs.get(), status.update(math::norm(rate), p.settling))};
  }

  // The next movement begins at "start".
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
