// The motion of an adaptive module that runs a discrete movement primitive: of axes (dmp_discrete) or of a
// pose (dmp_pose). It runs the component as it is and learns its weights.
//
// A demonstration begins with its first finite sample after the learner began to listen, or after a
// "restart", and is that of a movement with the current goal and duration, from there. Three samples in
// consecutive firings make one example, at the middle one. What comes later than the duration is ignored.
//
// The weights belong to a stiffness and to `scaled`; the place of the functions to the decay, which is part
// of the type. With `scaled`, an axis whose goal is within 1e-6 of its start learns nothing.
//
// While an input is NaN or infinite, see the component; a demonstration that is not finite teaches nothing.
// Source: Ijspeert et al., Neural Computation 25, 2013, equation 2.12; of a pose: Ude et al., ICRA 2014.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include <cca/base/math.hpp>
#include <cca/adaptive/module/adaptive_module.hpp>
#include <cca/adaptive/module/three_in_a_row.hpp>
#include <cca/adaptive/recursive_least_squares.hpp>
#include <cca/motor/dmp_discrete.hpp>
#include <cca/motor/dmp_pose.hpp>
#include <cca/motor/dmp_shapes.hpp>

namespace cca {

// `Velocity` is the space of the output "velocity"; Decay that of the canonical system, times 1000.
template <class Primitive, class Shape, Space S, Space Velocity, int Decay>
class discrete_motion {
public:
  using ode = typename Primitive::ode;
  using model = Shape;
  using default_learner = recursive_least_squares<model>;
  using demonstrated = S;
  using inputs = module_inputs<in<"reference", S>,
                               optional_in<"start", S>,
                               optional_in<"duration", movement_duration>,
                               optional_in<"restart", restart_signal>>;
  using outputs =
      module_outputs<maybe<"command", S>, maybe<"velocity", Velocity>, maybe<"progress", movement_progress>>;
  using vector = typename S::vector_type;
  using forcing = typename model::output;

  template <class Settings>
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::duration, 0.001, 1000>, duration),
                             (bounded<double, 0.1, 1000>, stiffness),
                             (bounded<double, 0, 1000>, goal_rate),
                             (bool, scaled),
                             (ode_settling, settling),
                             (Settings, settings),
                             (learned_files, files));
    parameters(double seconds = 1,
               double stiff = 25,
               double goal_follows = 12.5,
               bool scales = false,
               const ode_settling& settles = {1e-3, 1e-2},
               const Settings& of_learner = {},
               const learned_files& names = {})
        : duration(seconds),
          stiffness(stiff),
          goal_rate(goal_follows),
          scaled(scales),
          settling(settles),
          settings(of_learner),
          files(names) {}
    std::string check_at(double step) const {
      return detail::below_rate_bound(
          "duration", duration,
          std::max({stiffness / 2, goal_rate.value(), decay}) / detail::rate_bound(step), step);
    }
  };

  static std::vector<learned_header::constant> constants(const auto& p) {
    return {{"stiffness", p.stiffness}, {"scaled", p.scaled ? 1.0 : 0.0}};
  }

  template <class Give, class Parameters, class Teacher>
  [[gnu::always_inline]] auto step(const Give& give,
                                   const Parameters& p,
                                   const typename model::parameters& function,
                                   const Teacher& teach,
                                   const in<"reference", S>& reference,
                                   const optional_in<"start", S>& start,
                                   const optional_in<"duration", movement_duration>& duration,
                                   const optional_in<"restart", restart_signal>& restart,
                                   const optional_in<"demonstration", S>& shown,
                                   beat now) {
    const double seconds = duration ? duration[duration_axis{}] : p.duration.value();
    observe_demonstration(shown, reference.vector(), seconds, restart && restart.fresh(), now.dt(), p, teach);
    auto& with = primitive.p;
    with.weights = function.weights;
    with.duration = p.duration;
    with.stiffness = p.stiffness;
    with.decay = decay;
    with.goal_rate = p.goal_rate;
    with.scaled = p.scaled;
    with.settling = p.settling;
    const auto [position, velocity, progress, status] = primitive.process(
        {reference.vector(), reference.origin(), reference.fresh()}, start, duration, restart, now);
    maybe<"command", S> command;
    if (position) command = position.vector();
    if (progress) at = progress.vector();
    return give(status[ode_axis{}], at, command, velocity, progress);
  }

  // The next movement begins at "start".
  void start() {
    primitive.on_start();
    at.setOnes();
    seen.interrupt();
    showing = false;
  }

  // The goal is the last sample, the duration the time from the first to the last.
  static std::vector<example<model>> examples(std::span<const vector> movement,
                                              double seconds,
                                              const auto& p) {
    const double tau = seconds * static_cast<double>(movement.size() - 1);
    std::vector<example<model>> all;
    for (std::size_t i = 1; i + 1 < movement.size(); ++i)
      all.push_back({typename model::input(math::exp(-decay * static_cast<double>(i) * seconds / tau)),
                     wanted(movement[i - 1], movement[i], movement[i + 1], movement.front(), movement.back(),
                            seconds, tau, p)});
    return all;
  }

private:
  static constexpr double decay = 1e-3 * Decay, least_way = 1e-6;
  struct moment {
    vector y, goal;
    double tau, x;
  };

  // The answer of the model that makes the movement: the forcing term of a step, without its scale.
  static forcing wanted(const vector& before,
                        const vector& y,
                        const vector& after,
                        const vector& first,
                        const vector& goal,
                        double dt,
                        double tau,
                        const auto& p) {
    const forcing velocity = ode::way(before, after) / (2 * dt),
                  acceleration = (ode::way(y, after) - ode::way(before, y)) / (dt * dt);
    forcing f =
        tau * tau * acceleration - p.stiffness * (p.stiffness / 4 * ode::way(y, goal) - tau * velocity);
    if (!p.scaled) return f;
    const forcing way = ode::way(first, goal);
    for (int i = 0; i < f.size(); ++i) f[i] = std::abs(way[i]) < least_way ? 0.0 : f[i] / way[i];
    return f;
  }

  template <class Parameters, class Teacher>
  void observe_demonstration(const optional_in<"demonstration", S>& shown,
                             const vector& goal,
                             double seconds,
                             bool again,
                             double dt,
                             const Parameters& p,
                             const Teacher& teach) {
    if (!teach.listens() || again) {
      seen.interrupt();
      showing = false;
    }
    const double tau = std::max(1e-3, seconds);
    if (showing && tau <= largest_input) x *= math::exp(-decay * dt / tau);
    if (!teach.listens() || !shown || !shown.fresh() || !detail::all_finite(shown.vector()) ||
        !detail::all_finite(goal) || !(tau <= largest_input)) {
      seen.interrupt();
      return;
    }
    if (!showing) {
      first = shown.vector();
      x = 1;
      showing = true;
    }
    if (!seen.add({shown.vector(), goal, tau, x})) return;
    const moment& middle = seen[1];
    if (middle.x < math::exp(-decay)) return;
    teach(typename model::input(middle.x),
          wanted(seen[0].y, middle.y, seen[2].y, first, middle.goal, dt, middle.tau, p));
  }

  Primitive primitive;
  typename model::input at = model::input::Ones();
  detail::three_in_a_row<moment> seen;
  vector first = vector::Zero();
  double x = 1;  // the canonical variable of the demonstration
  bool showing = false;
};

}  // namespace cca
