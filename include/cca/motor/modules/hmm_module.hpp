// A hidden Markov model as an Adaptive Module: a movement that knows by itself which part of it is running.
//
//   cca::tracker<cca::hmm_module<hand_in_base, 12>, cca::tracking<hand_in_base>>      12 hidden states
//
//   in  "reference"      S                  the movement is learned relative to it, and moves with it
//   in  "start"          S                  optional: where it begins; else at the first learned position
//   in  "feedback"       S                  optional: the measured position, by which it knows where it is;
//                                           else its own command
//   in  "demonstration"  S                  optional: the movement to learn, at this reference
//   in  "learn"          learning_request   optional: a request of another component
//   out "command"        S                  maybe
//   out "velocity"       velocity_of<S>     maybe; unit of S per s
//   out "state"          hidden_state       maybe; the most likely state, counted from 0
//   out "ode"            ode_status_port    converged at rest
//   out "module"         module_status_port what the learner does, and whether this position was trained
//
// S is any space with one number per axis. Unlike gmr_module it needs no time: from the position and from the
// states before, it tells the part of the movement, and follows the attractor of this part on springs
// (equations/attractor_ode.hpp). So a movement that is held waits, and one that crosses itself goes on in its
// direction. A movement that begins at rest needs a demonstration in which it does not stay there.
//
//   h_k(t) = (sum_j h_j(t-1) a_jk) N(x; m_k^x, S_k^xx) / sum         as in hmm_motion.hpp; x = y - reference
//   g = reference + sum h_k (m_k^g + S_k^gx S_k^xx^-1 (x - m_k^x))   the attractor
//
// Several demonstrations may be shown: each begins where its samples have been interrupted, or where the
// controller starts. Three fresh samples in three consecutive firings make one example. Filter noise before:
// accelerations come from differences. The transitions belong to the clock of the demonstrations.
//
// Parameters: stiffness (per s), settling, settings (of the learner), files. A file that was learned with
// another stiffness is refused. It learns in batches only.
//
// Inputs (input_status.hpp): while one is NaN or infinite, the movement and its states stand still, the
// velocity is 0, only the statuses are published besides, and "ode" is `unreadable`; beyond 1e12 it is cut,
// with `clamped`; so is a position at which no state can be told from the others because numbers overflow. A
// demonstration that is NaN or infinite is never learned.
//
// Errors: learner.model; `cca::refused` for files. Cost: that of hmm_motion, the same again for the trained
// region, and four derivatives of the springs. Source: hidden_markov_learning.hpp, hmm_motion.hpp,
// equations/attractor_ode.hpp.
// Example: tests/runtime/adaptive/hmm_module.cpp.
#pragma once

#include <cca/base/math/reductions.hpp>
#include <cca/adaptive/module/adaptive_module.hpp>
#include <cca/adaptive/module/three_in_a_row.hpp>
#include <cca/adaptive/ode_solver.hpp>
#include <cca/component/input_status.hpp>
#include <cca/motor/equations/attractor_ode.hpp>
#include <cca/motor/modules/attractor_parameters.hpp>
#include <cca/motor/hidden_markov_learning.hpp>
#include <cca/motor/hmm_motion.hpp>

namespace cca {

template <detail::LinearSpace S, int K, class Integrator>
class hidden_markov_motion {
public:
  using ode = attractor_ode<S::size>;
  using model = hidden_markov_function<S, S, K>;
  using default_learner = baum_welch<model>;
  using demonstrated = S;
  using inputs = module_inputs<in<"reference", S>, optional_in<"start", S>, optional_in<"feedback", S>>;
  using outputs =
      module_outputs<maybe<"command", S>, maybe<"velocity", velocity_of<S>>, maybe<"state", hidden_state>>;

  template <class Settings>
  using parameters = detail::attractor_parameters<Settings>;

  static auto constants(const auto& p) { return detail::constants_of(p); }

  template <class Give, class Parameters, class Teacher>
  auto step(const Give& give,
            const Parameters& p,
            const typename model::parameters& function,
            const Teacher& teach,
            const in<"reference", S>& reference,
            const optional_in<"start", S>& start,
            const optional_in<"feedback", S>& feedback,
            const optional_in<"demonstration", S>& shown,
            beat now) {
    detail::input_check read;
    const vector centre = read(reference.vector());
    const bool is_measured = feedback && feedback.origin() != never;
    const vector measured = is_measured ? vector(read(feedback.vector())) : vector(vector::Zero());
    const bool can_begin = begun || (start ? detail::has_come(start) : reference.origin() != never);
    maybe<"command", S> command;
    maybe<"velocity", velocity_of<S>> velocity;
    maybe<"state", hidden_state> state;
    if (!can_begin || read.unreadable()) {
      interrupt(teach);
      if (begun) velocity = vector(vector::Zero());
      return give(status_of(read.get(), ode_state.get()),
                  vector((is_measured ? measured : vector(solver.get().template head<S::size>())) - centre),
                  command, velocity, state);
    }
    const typename ode::parameters with{p.stiffness};
    if (!shown || !shown.fresh()) interrupt(teach);
    else if (seen.add({shown.vector(), centre})) learn(now.dt(), with, teach);
    if (!begun) {
      typename ode::state x = ode::state::Zero();
      // Without a start where the first parts of the demonstrations were.
      x.template head<S::size>() =
          start ? vector(read(start.vector()))
                : vector(centre + math::product(function.mixture.means.template topRows<S::size>(),
                                                function.mixture.priors));
      solver.set(x);
    }
    const vector at = (is_measured ? measured : vector(solver.get().template head<S::size>())) - centre;
    const weights predicted =
        begun ? weights(math::product(function.transitions.transpose(), shares)) : function.mixture.priors;
    const auto answer = model::regress_with(function, predicted, at);
    begun = true;
    if (detail::all_finite(answer.responsibilities) && detail::all_finite(answer.mean)) {
      shares = answer.responsibilities;
      attractor = answer.mean;
    } else {
      read.note_clamped();
    }
    const vector goal = read(vector(centre + attractor));
    if (!solver.advance(goal, with, now.dt())) read.note_clamped();
    command = vector(solver.get().template head<S::size>());
    velocity = vector(solver.get().template tail<S::size>());
    Eigen::Index likely = 0;
    shares.maxCoeff(&likely);
    state = static_cast<double>(likely);
    const double rate = math::norm(solver.rate(goal, with));
    return give(status_of(read.get(), ode_state.update(rate, p.settling)), at, command, velocity, state);
  }

  // The next movement begins at "start", and the next demonstration anew.
  void start() {
    begun = false;
    was_started = true;
    seen.interrupt();
    ode_state = {};
    shares.setConstant(1.0 / K);
    attractor.setZero();
  }

private:
  using vector = typename ode::vector;
  using weights = typename model::weights;
  struct moment {
    vector y, centre;
  };

  template <class Teacher>
  void interrupt(const Teacher& teach) {
    seen.interrupt();
    teach.begin_demonstration();
  }
  template <class Teacher>
  void learn(double dt, const typename ode::parameters& with, const Teacher& teach) {
    if (was_started) teach.begin_demonstration();
    was_started = false;
    const moment& middle = seen[1];
    const vector velocity = (seen[2].y - seen[0].y) / (2 * dt),
                 acceleration = (seen[2].y - 2 * middle.y + seen[0].y) / (dt * dt);
    teach(middle.y - middle.centre,
          ode::wanted_attractor(middle.y, velocity, acceleration, with) - middle.centre);
  }

  ode_solver<ode, Integrator> solver;
  ode_monitor ode_state;
  detail::three_in_a_row<moment> seen;
  weights shares = weights::Constant(1.0 / K);
  vector attractor = vector::Zero();
  bool begun = false, was_started = false;
};

template <detail::LinearSpace S,
          int K,
          Learner Rule = baum_welch<hidden_markov_function<S, S, K>>,
          int Capacity = 2000,
          class Integrator = rk4>
struct hmm_module : adaptive_module<hidden_markov_motion<S, K, Integrator>, Rule, Capacity> {};

}  // namespace cca
