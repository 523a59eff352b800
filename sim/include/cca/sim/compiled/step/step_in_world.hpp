// One step of physics in a compiled world: forces, contacts, motion, then what of it is read and accounted.
#pragma once

#include <cstddef>

#include <cca/sim/compiled/compiled_state.hpp>
#include <cca/sim/compiled/compiled_trouble.hpp>
#include <cca/sim/compiled/contacts/contacts.hpp>
#include <cca/sim/compiled/readings/felt_contact.hpp>
#include <cca/sim/compiled/readings/motor_work.hpp>
#include <cca/sim/compiled/readings/outer_forces.hpp>
#include <cca/sim/compiled/tree_step.hpp>
#include <cca/sim/robot/model/robot_world_settings.hpp>

namespace cca::sim::detail {

// Of two changes of the velocities, without and with contacts: the smaller one, or none if they go two ways.
// It is what goes on in the next step: an impact does not, and at rest nothing does.
template <class Vector>
constexpr Vector lasting(const Vector& without, const Vector& with) {
  using Real = typename Vector::value_type;
  Vector v{};
  const Real zero(0.0);
  for (std::size_t k = 0; k < v.size(); ++k)
    v[k] = smaller(larger(without[k], zero), larger(with[k], zero)) +
           larger(smaller(without[k], zero), smaller(with[k], zero));
  return v;
}

template <class R, class Real>
struct step_in_world {
  static constexpr bool has_own = robots::touches_itself<R>;
  static constexpr bool has_shapes = probes_of<R>::shape_count > 0;
  static constexpr double beat = 1 / cca::detail::hz_of<typename R::rate>;

  const robot_world_settings& settings;
  const surroundings_for<Real>& around;
  const built_robot<R, Real>& built;
  compiled_state<R, Real>& state;

  double seconds() const { return beat / settings.steps_per_beat; }

  // Before the first step of a beat.
  void begin_beat() {
    auto& d = state.drives;
    for (std::size_t c = 0; c < state.joints.size(); ++c) {
      d.pulleys[c].wanted = Real(1 / beat) * (Real(d.laws[c].position) - d.pulleys[c].wound);
      state.joints[c].torque = Real(0.0);
    }
    state.loads = {}, state.end_forces = {};
  }
  // Of the beat's steps the one with this number. `state.trouble` says whether the world can still be right.
  void make(int number) {
    const double h = seconds();
    auto& m = state.motion;
    tree_step<R, Real> now(h, built);
    now.begin(m, settings.engine.gravity);
    pull_and_push<R>(state, now);
    now.solve(m, state.drives);
    bool touches = false;
    if constexpr (has_shapes) {
      touches = around.more() || has_own || (probes_of<R>::count > 0 && around.under.exists);
      if (touches) touch(now, h, (number + 0.5) * h);
    }
    if (!touches) now.end(m, state.drives, now.change);
    account_motors<R>(state, h, Real(h / beat));
    state.trouble = trouble_of<R>(m, settings.plausible, h);
    if constexpr (has_shapes && !is_in_lanes<Real>)
      if (around.balls.count > 0 && !state.trouble)
        state.trouble = state.around.trouble(around, settings.plausible, h);
  }
  // After the last one.
  void end_beat() {
    for (std::size_t c = 0; c < state.joints.size(); ++c)
      state.joints[c].angle = state.motion.q[c], state.joints[c].velocity = state.motion.dq[c];
  }

private:
  // `after`: of the beat's begin, in the middle of the step, s.
  void touch(tree_step<R, Real>& now, double h, double after) {
    contacts_in_step<R, Real> contacts;
    const auto without = now.change;
    bool has_more = false;
    if constexpr (!is_in_lanes<Real>)
      if (has_more = around.more(); has_more)
        contacts.solve_with_more(now, state.motion, around, state.around, state.impulses, h, after,
                                 settings.engine.gravity);
    if (!has_more) contacts.solve(now, state.motion, around, state.impulses, h);
    now.end(state.motion, state.drives, lasting(without, now.change));
    begin_step(state.contacts);
    contacts.each(h, [&](const auto& c) {
      if (c.shape < 0) return;
      feel<R>(now, c, Real(h / beat), state);
      add_to(state.contacts, c, h);
    });
  }
};

}  // namespace cca::sim::detail
