// A rhythmic movement primitive as a component (the "DMP Transformation System" of the source document,
// section 6.3): it turns the phase and amplitude of an oscillator into a learned periodic movement around a
// goal.
//
//   cca::node<"dmp", cca::dmp_rhythmic<leg_angles, stride, 25>, cca::timed<1>>       25 basis functions
//
//   in  "phase"      over<phase, Axis>      rad
//   in  "amplitude"  over<amplitude, Axis>  factor on the shape; 0 or less: the position settles at the goal
//   in  "frequency"  over<frequency, Axis>  Hz, optional: else the parameter; at least 0.01
//   in  "goal"       S                      the centre of the movement; may change
//   in  "start"      S                      optional: where the movement begins; else at the goal
//   out "position"   S                      maybe
//   out "velocity"   velocity_of<S>         maybe; unit of S per s
//   out "status"     ode_status_port        converged at rest; the running phase does not count
//
// S is any space with one number per axis. If "start" is wired, the component waits for its first sample and
// publishes only its status until then. Precondition: the phase advances at the frequency. The component
// assumes this between two firings and reads the phase again in each firing.
//
// Inputs (input_status.hpp): while one is NaN or infinite, the movement stands still, the velocity is 0,
// nothing else but the status is published, and the status is `unreadable`; beyond 1e12, and a frequency
// below 0.01 Hz, it is cut and the status is `clamped`. A frequency that is too high for the rate of the node
// (2 pi f max(stiffness / 2, 1) above 16 / dt) makes the movement slower than its phase, with the same
// status.
//
// Errors: none. Cost: five times N exponentials; up to 13 times as much at high frequencies. Source:
// equations/dmp_rhythmic_ode.hpp. Example: tests/runtime/motor/dmp.cpp.
#pragma once

#include <algorithm>
#include <numbers>
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
#include <cca/motor/equations/dmp_rhythmic_ode.hpp>
#include <cca/motor/spaces.hpp>

namespace cca {

template <detail::LinearSpace S, class Axis, int N, class Integrator = rk4>
struct dmp_rhythmic {
  using ode = dmp_rhythmic_ode<S::size, N>;
  using weight_matrix = Eigen::Matrix<double, S::size, N>;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (weight_matrix, weights),
                             (cca::quantity<cca::frequency, 0.01, 100>, frequency),
                             (bounded<double, 0.1, 1000>, stiffness),
                             (ode_settling, settling));
    parameters(const weight_matrix& shape = weight_matrix::Zero(),
               double turns_per_second = 1,
               double stiff = 25,
               const ode_settling& settles = {1e-3, 1e-2})
        : weights(shape), frequency(turns_per_second), stiffness(stiff), settling(settles) {}
    std::string_view check() const { return detail::too_large(weights, "a weight is above 1e12"); }
    std::string check_at(double step) const {
      return detail::above_rate_bound(
          "frequency", frequency,
          detail::rate_bound(step) / (2 * std::numbers::pi * std::max(stiffness / 2, 1.0)), step);
    }
  };
  parameters p{};

  auto process(in<"phase", over<cca::phase, Axis>> phase,
               in<"amplitude", over<cca::amplitude, Axis>> size,
               optional_in<"frequency", over<cca::frequency, Axis>> turns,
               in<"goal", S> goal,
               optional_in<"start", S> start,
               beat now)
      -> std::tuple<maybe<"position", S>, maybe<"velocity", velocity_of<S>>, out<"status", ode_status_port>> {
    constexpr int D = S::size;
    using vector = typename ode::vector;
    detail::input_check inputs;
    const vector centre = inputs(goal.vector());
    const double hertz =
        inputs.number(turns ? turns[Axis{}] : p.frequency.value(), least_frequency, largest_input);
    const double swing = std::max(0.0, inputs.number(size[Axis{}])), at_phase = inputs.number(phase[Axis{}]);
    const typename ode::parameters at{p.weights, p.stiffness};
    typename ode::input u;
    u << centre, swing, 1 / (2 * std::numbers::pi * hertz);
    const bool can_begin = begun || (start ? detail::has_come(start) : goal.origin() != never);
    if (!can_begin || inputs.unreadable()) {
      maybe<"velocity", velocity_of<S>> still;
      if (begun) still = vector(vector::Zero());
      return {{}, still, status_of(inputs.get(), status.get())};
    }
    typename ode::state x = solver.get();
    if (!begun) {
      x.setZero();
      x.template head<D>() = start ? inputs(start.vector()) : centre;
      begun = true;
    }
    // The input is the phase at the end of this step; the solver begins one step earlier.
    x[2 * D] = at_phase - 2 * std::numbers::pi * hertz * now.dt();
    solver.set(x);
    if (!solver.advance(u, at, now.dt())) inputs.note_clamped();
    const typename ode::state rate = solver.rate(u, at);
    return {vector(solver.get().template head<D>()), vector(rate.template head<D>()),
            status_of(inputs.get(), status.update(math::norm(rate.template head<2 * D>()), p.settling))};
  }

  // The next movement begins at "start".
  void on_start() {
    begun = false;
    status = {};
  }

private:
  static constexpr double least_frequency = 0.01;  // Hz
  ode_solver<ode, Integrator> solver;
  ode_monitor status;
  bool begun = false;
};

}  // namespace cca
