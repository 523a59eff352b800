// A motion model by Gaussian mixture regression as an adaptive module: it learns a movement over a time or a
// progress from one or more demonstrations, and how much these differ.
//
//   cca::tracker<cca::gmr_module<lesson_time, arm_angles, 12>, cca::tracking<arm_angles>>     12 Gaussians
//
//   in  "input"          Input              a space of one axis: a time, a progress; not a phase
//   in  "reference"      S                  the movement is learned relative to it, and moves with it
//   in  "start"          S                  optional: where it begins; else at the first learned position
//   in  "demonstration"  S                  optional: the movement to learn, at this input and reference
//   in  "learn"          learning_request   optional: a request of another component
//   out "command"        S                  maybe
//   out "velocity"       velocity_of<S>     maybe; unit of S per s
//   out "spread"         spread_of<S>       maybe; standard deviation of the attractor, in the unit of S
//   out "ode"            ode_status_port    converged at rest
//   out "module"         module_status_port what the learner does, and whether this input was trained
//
// S is any space with one number per axis. The mixture answers with an attractor, which the command follows
// on springs (equations/attractor_ode.hpp): so velocities stay finite whatever the input does, and on a
// demonstrated input the command goes through the demonstration without delay. Three fresh demonstrations in
// three consecutive firings make one example. Filter noise before: accelerations come from differences.
//
// Parameters: stiffness (per s), settling, settings (of the learner), files. A file that was learned with
// another stiffness is refused. It learns in batches only.
//
// Inputs (input_status.hpp): while one is NaN or infinite, the movement stands still, the velocity is 0, only
// the statuses are published besides, and "ode" is `unreadable`; beyond 1e12 it is cut, with `clamped`. A
// demonstration that is NaN or infinite is never learned.
//
// Errors: learner.model; `cca::refused` for files. Cost: a logarithm, an exponential and O^2 products per
// Gaussian, the same again for the trained region, and four derivatives of the springs. Source:
// equations/gaussian_mixture.hpp, equations/attractor_ode.hpp.
// Example: tests/runtime/adaptive/other_modules.cpp.
#pragma once

#include <cmath>
#include <type_traits>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/space/messages/space_in_words.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/adaptive/module/adaptive_module.hpp>
#include <cca/adaptive/module/three_in_a_row.hpp>
#include <cca/adaptive/ode_solver.hpp>
#include <cca/component/input_status.hpp>
#include <cca/motor/equations/attractor_ode.hpp>
#include <cca/motor/modules/attractor_parameters.hpp>
#include <cca/motor/gaussian_mixture_learning.hpp>
#include <cca/motor/gmr.hpp>

namespace cca {

namespace detail {

template <class Input>
struct no_line {
  static constexpr void tell(text& m) {
    m << "cca::gmr_module: its input is " << space_in_words<Input>();
    if (Input::size != 1)
      m << ", which has " << Input::size
        << " axes, and a mixture is learned over one: name a space of one axis, as a time or a progress";
    else
      m << ", which is a phase, and a mixture is learned over a line, not a circle: use "
           "cca::dmp_rhythmic_module for a movement over a phase";
  }
};

}  // namespace detail

template <detail::LinearSpace Input, detail::LinearSpace S, int K, class Integrator>
class regression_motion {
  static_assert(
      detail::holds_or_tells<(Input::size == 1 && !std::is_same_v<typename Input::domain, cca::phase>),
                             detail::no_line<Input>>::value);

public:
  using ode = attractor_ode<S::size>;
  using model = mixture_function<Input, S, K>;
  using default_learner = expectation_maximisation<model>;
  using demonstrated = S;
  using inputs = module_inputs<in<"input", Input>, in<"reference", S>, optional_in<"start", S>>;
  using outputs =
      module_outputs<maybe<"command", S>, maybe<"velocity", velocity_of<S>>, maybe<"spread", spread_of<S>>>;

  template <class Settings>
  using parameters = detail::attractor_parameters<Settings>;

  static auto constants(const auto& p) { return detail::constants_of(p); }

  template <class Give, class Parameters, class Teacher>
  [[gnu::always_inline]] auto step(const Give& give,
                                   const Parameters& p,
                                   const typename model::parameters& function,
                                   const Teacher& teach,
                                   const in<"input", Input>& input,
                                   const in<"reference", S>& reference,
                                   const optional_in<"start", S>& start,
                                   const optional_in<"demonstration", S>& shown,
                                   beat now) {
    using scalar = typename model::input;
    detail::input_check read;
    const vector centre = read(reference.vector());
    const scalar at = read(input.vector());
    const bool can_begin = begun || (start ? detail::has_come(start) : reference.origin() != never);
    maybe<"command", S> command;
    maybe<"velocity", velocity_of<S>> velocity;
    maybe<"spread", spread_of<S>> spread;
    if (!can_begin || read.unreadable()) {
      seen.interrupt();
      if (begun) velocity = vector(vector::Zero());
      return give(status_of(read.get(), ode_state.get()), at, command, velocity, spread);
    }
    const typename ode::parameters with{p.stiffness};
    if (!shown || !shown.fresh()) seen.interrupt();
    else if (seen.add({shown.vector(), centre, at})) learn(now.dt(), with, teach);
    const auto answer = regress<1, S::size, K>(
        function, function.priors, at, [](const scalar& x, const scalar& m) { return scalar(x - m); });
    // The mean of a mixture with large numbers far from its input; a finite one is always followed.
    const vector attractor = read(vector(centre + answer.mean));
    if (!begun) {
      typename ode::state x = ode::state::Zero();
      x.template head<S::size>() = start ? read(start.vector()) : attractor;
      solver.set(x);
      begun = true;
    }
    if (!solver.advance(attractor, with, now.dt())) read.note_clamped();
    command = vector(solver.get().template head<S::size>());
    velocity = vector(solver.get().template tail<S::size>());
    vector deviation;
    for (int i = 0; i < S::size; ++i) deviation[i] = math::sqrt(std::max(0.0, answer.covariance(i, i)));
    spread = deviation;
    const double rate = math::norm(solver.rate(attractor, with));
    return give(status_of(read.get(), ode_state.update(rate, p.settling)), at, command, velocity, spread);
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
    vector y, centre;
    typename model::input x;
  };

  template <class Teacher>
  void learn(double dt, const typename ode::parameters& with, const Teacher& teach) {
    const vector velocity = (seen[2].y - seen[0].y) / (2 * dt),
                 acceleration = (seen[2].y - 2 * seen[1].y + seen[0].y) / (dt * dt);
    teach(seen[1].x, ode::wanted_attractor(seen[1].y, velocity, acceleration, with) - seen[1].centre);
  }

  ode_solver<ode, Integrator> solver;
  ode_monitor ode_state;
  detail::three_in_a_row<moment> seen;
  bool begun = false;
};

template <detail::LinearSpace Input,
          detail::LinearSpace S,
          int K,
          Learner Rule = expectation_maximisation<mixture_function<Input, S, K>>,
          int Capacity = 2000,
          class Integrator = rk4>
struct gmr_module : adaptive_module<regression_motion<Input, S, K, Integrator>, Rule, Capacity> {};

}  // namespace cca
