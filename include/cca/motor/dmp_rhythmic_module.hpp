// A rhythmic movement primitive as an adaptive module: it learns its shape and keeps it in a file (the "DMP
// Transformation System" of the seed, section 6.3).
//
//   cca::tracker<cca::dmp_rhythmic_module<leg_angles, stride, 25>, cca::tracking<leg_angles>>
//
//   in  "phase"          over<phase, Axis>      rad
//   in  "amplitude"      over<amplitude, Axis>  0 or less: the command settles at the reference
//   in  "frequency"      over<frequency, Axis>  Hz, optional: else the parameter; at least 0.01
//   in  "reference"      S                      the centre of the movement; may change
//   in  "start"          S                      optional: where the movement begins; else at the reference
//   in  "demonstration"  S                      optional: the movement to learn, at this phase, amplitude,
//                                               frequency and reference
//   in  "learn"          learning_request       optional: a request of another component
//   out "command"        S                      maybe
//   out "velocity"       velocity_of<S>         maybe; unit of S per s
//   out "ode"            ode_status_port        converged at rest
//   out "module"         module_status_port     what the learner does, and whether this phase was trained
//
// S is any space with one number per axis. If "start" is wired, the module waits for its first sample and
// publishes only its statuses until then.
//
// Three fresh demonstrations in three consecutive firings make one example: position, velocity and
// acceleration at the middle one, by central differences. Filter noise before. Examples with an amplitude of
// at most 1e-3 are ignored. A program learns between two beats through `c.get<"dmp.module">().learning`, a
// cca::training.
//
// Parameters: frequency, stiffness, settling, settings (of the learner), files (read on load, written on
// save). The weights depend on the stiffness: a file that was learned with another stiffness is refused.
//
// Inputs (input_status.hpp): while one is NaN or infinite, the movement stands still, the velocity is 0, only
// the statuses are published besides, "ode" is `unreadable`, and the count of demonstrations restarts; beyond
// 1e12, and a frequency below 0.01 Hz, it is cut and "ode" is `clamped`. A frequency that is too high for the
// rate of the node (2 pi f max(stiffness / 2, 1) above 16 / dt) makes the movement slower than its phase,
// with the same status.
//
// Errors: learner.model; `cca::refused` for files. Cost: five times N exponentials, up to 13 times as much at
// high frequencies; with a demonstration also one step of the learner. Source:
// equations/dmp_rhythmic_ode.hpp. Example: tests/runtime/adaptive/tracker.cpp.
#pragma once

#include <algorithm>
#include <array>
#include <numbers>
#include <string>
#include <tuple>

#include <cca/component/input_status.hpp>
#include <cca/adaptive/locally_weighted_regression.hpp>
#include <cca/adaptive/ode_solver.hpp>
#include <cca/adaptive/ode_status.hpp>
#include <cca/adaptive/numerics/rate_bound.hpp>
#include <cca/adaptive/training.hpp>
#include <cca/component/beat.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/motor/equations/dmp_rhythmic_ode.hpp>
#include <cca/motor/dmp_shapes.hpp>

namespace cca {

template <detail::LinearSpace S,
          class Axis,
          int N,
          Learner Rule = locally_weighted_regression<rhythmic_shape<S, N>>,
          int Capacity = 2000,
          class Integrator = rk4>
struct dmp_rhythmic_module {
  using ode = dmp_rhythmic_ode<S::size, N>;
  using model = rhythmic_shape<S, N>;
  static constexpr bool bound = detail::check_models<typename Rule::model, model>();
  using learner = std::conditional_t<bound, Rule, locally_weighted_regression<model>>;
  using learner_settings = typename learner::settings;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::frequency, 0.01, 100>, frequency),
                             (bounded<double, 0.1, 1000>, stiffness),
                             (ode_settling, settling),
                             (learner_settings, settings),
                             (learned_files, files));
    std::string check_at(double step) const {
      return detail::above_rate_bound(
          "frequency", frequency,
          detail::rate_bound(step) / (2 * std::numbers::pi * std::max(stiffness / 2, 1.0)), step);
    }
  };
  parameters p{1.0, 25.0, {1e-3, 1e-2}, {}, {}};
  training<learner, Capacity> learning;

  auto process(in<"phase", over<cca::phase, Axis>> phase,
               in<"amplitude", over<cca::amplitude, Axis>> size,
               optional_in<"frequency", over<cca::frequency, Axis>> turns,
               in<"reference", S> reference,
               optional_in<"start", S> start,
               optional_in<"demonstration", S> demonstration,
               optional_in<"learn", learning_request> call,
               beat now) -> std::tuple<maybe<"command", S>,
                                       maybe<"velocity", velocity_of<S>>,
                                       out<"ode", ode_status_port>,
                                       out<"module", module_status_port>> {
    constexpr int D = S::size;
    using vector = typename ode::vector;
    if (call && call.fresh()) learning.obey(call.template as<learning_call>());
    detail::input_check inputs;
    const vector centre = inputs(reference.vector());
    const double hertz =
        inputs.number(turns ? turns[Axis{}] : p.frequency.value(), least_frequency, largest_input);
    const double swing = std::max(0.0, inputs.number(size[Axis{}])), at_phase = inputs.number(phase[Axis{}]);
    const double tau = 1 / (2 * std::numbers::pi * hertz);
    const typename ode::parameters at{learning.get().function.weights, p.stiffness};
    typename ode::input u;
    u << centre, swing, tau;
    const bool can_begin = begun || (start ? detail::has_come(start) : reference.origin() != never);
    if (!can_begin || inputs.unreadable()) {
      seen_in_a_row = 0;
      maybe<"velocity", velocity_of<S>> still;
      if (begun) still = vector(vector::Zero());
      return {{},
              still,
              status_of(inputs.get(), ode_state.get()),
              learning.status({at_phase, swing}, p.settings)};
    }
    observe_demonstration(demonstration, {at_phase, swing}, centre, tau, now.dt());
    typename ode::state x = solver.get();
    if (!begun) {
      x.setZero();
      x.template head<D>() = start ? inputs(start.vector()) : centre;
      begun = true;
    }
    // The input is the phase at the end of this step; the solver begins one step earlier.
    x[2 * D] = at_phase - now.dt() / tau;
    solver.set(x);
    if (!solver.advance(u, at, now.dt())) inputs.note_clamped();
    const typename ode::state rate = solver.rate(u, at);
    return {vector(solver.get().template head<D>()), vector(rate.template head<D>()),
            status_of(inputs.get(), ode_state.update(rate.template head<2 * D>().norm(), p.settling)),
            learning.status({at_phase, swing}, p.settings)};
  }

  void on_load() {
    if (!p.files.load.view().empty()) learning.load(std::string(p.files.load.view()), constants());
  }
  void on_save() {
    if (!p.files.save.view().empty()) learning.save(std::string(p.files.save.view()), constants());
  }
  // The next movement begins at "start".
  void on_start() {
    begun = false;
    seen_in_a_row = 0;
    ode_state = {};
  }

  // The weights depend on the stiffness, so a file states it.
  std::vector<learned_header::constant> constants() const { return {{"stiffness", p.stiffness}}; }

private:
  using input = typename model::input;
  struct moment {
    typename ode::vector y, goal;
    input x;
    double tau;
  };

  [[gnu::always_inline]] void observe_demonstration(const optional_in<"demonstration", S>& y,
                                                    const input& x,
                                                    const typename ode::vector& goal,
                                                    double tau,
                                                    double dt) {
    if (!y || !y.fresh()) {
      seen_in_a_row = 0;
      return;
    }
    last = {last[1], last[2], moment{y.vector(), goal, x, tau}};
    if (++seen_in_a_row < 3 || last[1].x[1] <= least_swing) return;
    const typename ode::vector velocity = (last[2].y - last[0].y) / (2 * dt),
                               acceleration = (last[2].y - 2 * last[1].y + last[0].y) / (dt * dt);
    learning.teach(
        last[1].x,
        ode::wanted_forcing(last[1].y, velocity, acceleration, last[1].goal, last[1].tau, {{}, p.stiffness}),
        p.settings);
  }
  static constexpr double least_swing = 1e-3, least_frequency = 0.01;  // no unit, Hz

  ode_solver<ode, Integrator> solver;
  ode_monitor ode_state;
  std::array<moment, 3> last{};
  int seen_in_a_row = 0;
  bool begun = false;
};

}  // namespace cca
