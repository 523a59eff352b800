// A rhythmic movement primitive as an adaptive module: it learns its shape and keeps it in a file (the "DMP
// Transformation System" of the source document, section 6.3).
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
// It is a cca::adaptive_module (adaptive/module/adaptive_module.hpp) of a rhythmic_motion.
//
// Errors: learner.model; `cca::refused` for files. Cost: five times N exponentials, up to 13 times as much at
// high frequencies; with a demonstration also one step of the learner. Source:
// equations/dmp_rhythmic_ode.hpp. Example: tests/runtime/adaptive/tracker.cpp.
#pragma once

#include <algorithm>
#include <numbers>
#include <string>
#include <tuple>

#include <cca/base/math/reductions.hpp>
#include <cca/component/input_status.hpp>
#include <cca/adaptive/locally_weighted_regression.hpp>
#include <cca/adaptive/ode_solver.hpp>
#include <cca/adaptive/module/adaptive_module.hpp>
#include <cca/adaptive/module/three_in_a_row.hpp>
#include <cca/adaptive/numerics/rate_bound.hpp>
#include <cca/motor/equations/dmp_rhythmic_ode.hpp>
#include <cca/motor/dmp_shapes.hpp>

namespace cca {

template <detail::LinearSpace S, class Axis, int N, class Integrator>
class rhythmic_motion {
public:
  using ode = dmp_rhythmic_ode<S::size, N>;
  using model = rhythmic_shape<S, N>;
  using default_learner = locally_weighted_regression<model>;
  using demonstrated = S;
  using inputs = module_inputs<in<"phase", over<cca::phase, Axis>>,
                               in<"amplitude", over<cca::amplitude, Axis>>,
                               optional_in<"frequency", over<cca::frequency, Axis>>,
                               in<"reference", S>,
                               optional_in<"start", S>>;
  using outputs = module_outputs<maybe<"command", S>, maybe<"velocity", velocity_of<S>>>;

  template <class Settings>
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::frequency, 0.01, 100>, frequency),
                             (bounded<double, 0.1, 1000>, stiffness),
                             (ode_settling, settling),
                             (Settings, settings),
                             (learned_files, files));
    parameters(double turns_per_second = 1,
               double stiff = 25,
               const ode_settling& settles = {1e-3, 1e-2},
               const Settings& of_learner = {},
               const learned_files& names = {})
        : frequency(turns_per_second),
          stiffness(stiff),
          settling(settles),
          settings(of_learner),
          files(names) {}
    std::string check_at(double step) const {
      return detail::above_rate_bound(
          "frequency", frequency,
          detail::rate_bound(step) / (2 * std::numbers::pi * std::max(stiffness / 2, 1.0)), step);
    }
  };

  // The weights depend on the stiffness, so a file states it.
  static std::vector<learned_header::constant> constants(const auto& p) {
    return {{"stiffness", p.stiffness}};
  }

  // docs/compilers.md says why it is inlined.
  template <class Give, class Parameters, class Teacher>
  [[gnu::always_inline]] auto step(const Give& give,
                                   const Parameters& p,
                                   const typename model::parameters& function,
                                   const Teacher& teach,
                                   const in<"phase", over<cca::phase, Axis>>& phase,
                                   const in<"amplitude", over<cca::amplitude, Axis>>& size,
                                   const optional_in<"frequency", over<cca::frequency, Axis>>& turns,
                                   const in<"reference", S>& reference,
                                   const optional_in<"start", S>& start,
                                   const optional_in<"demonstration", S>& demonstration,
                                   beat now) {
    constexpr int D = S::size;
    detail::input_check read;
    const vector centre = read(reference.vector());
    const double hertz =
        read.number(turns ? turns[Axis{}] : p.frequency.value(), least_frequency, largest_input);
    const double swing = std::max(0.0, read.number(size[Axis{}])), at_phase = read.number(phase[Axis{}]);
    const double tau = 1 / (2 * std::numbers::pi * hertz);
    const typename ode::parameters at{function.weights, p.stiffness};
    typename ode::input u;
    u << centre, swing, tau;
    const bool can_begin = begun || (start ? detail::has_come(start) : reference.origin() != never);
    if (!can_begin || read.unreadable()) {
      seen.interrupt();
      maybe<"velocity", velocity_of<S>> still;
      if (begun) still = vector(vector::Zero());
      return give(status_of(read.get(), ode_state.get()), {at_phase, swing}, {}, still);
    }
    observe_demonstration(demonstration, {at_phase, swing}, centre, tau, now.dt(), p.stiffness, teach);
    typename ode::state x = solver.get();
    if (!begun) {
      x.setZero();
      x.template head<D>() = start ? read(start.vector()) : centre;
      begun = true;
    }
    // The input is the phase at the end of this step; the solver begins one step earlier.
    x[2 * D] = at_phase - now.dt() / tau;
    solver.set(x);
    if (!solver.advance(u, at, now.dt())) read.note_clamped();
    const typename ode::state rate = solver.rate(u, at);
    return give(status_of(read.get(), ode_state.update(math::norm(rate.template head<2 * D>()), p.settling)),
                {at_phase, swing}, vector(solver.get().template head<D>()), vector(rate.template head<D>()));
  }

  // The next movement begins at "start".
  void start() {
    begun = false;
    seen.interrupt();
    ode_state = {};
  }

private:
  using vector = typename ode::vector;
  struct moment {
    vector y, goal;
    typename model::input x;
    double tau;
  };

  template <class Teacher>
  [[gnu::always_inline]] void observe_demonstration(const optional_in<"demonstration", S>& y,
                                                    const typename model::input& x,
                                                    const vector& goal,
                                                    double tau,
                                                    double dt,
                                                    double stiffness,
                                                    const Teacher& teach) {
    if (!y || !y.fresh()) {
      seen.interrupt();
      return;
    }
    if (!seen.add({y.vector(), goal, x, tau}) || seen[1].x[1] <= least_swing) return;
    const moment& middle = seen[1];
    const vector velocity = (seen[2].y - seen[0].y) / (2 * dt),
                 acceleration = (seen[2].y - 2 * middle.y + seen[0].y) / (dt * dt);
    teach(middle.x,
          ode::wanted_forcing(middle.y, velocity, acceleration, middle.goal, middle.tau, {{}, stiffness}));
  }
  static constexpr double least_swing = 1e-3, least_frequency = 0.01;  // no unit, Hz

  ode_solver<ode, Integrator> solver;
  ode_monitor ode_state;
  detail::three_in_a_row<moment> seen;
  bool begun = false;
};

template <detail::LinearSpace S,
          class Axis,
          int N,
          Learner Rule = locally_weighted_regression<rhythmic_shape<S, N>>,
          int Capacity = 2000,
          class Integrator = rk4>
struct dmp_rhythmic_module : adaptive_module<rhythmic_motion<S, Axis, N, Integrator>, Rule, Capacity> {};

}  // namespace cca
