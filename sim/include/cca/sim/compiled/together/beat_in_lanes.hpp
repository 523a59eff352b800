// A beat of several worlds of one robot in the lanes of a vector.
//
// Worlds go together if only their motion, the shape and the friction of their ground, their masses and their
// drives differ. Each has then the bits of a beat alone; a world that can't be right any more is as it was
// before the beat, with its own trouble, and the others go on. One with more contacts than a world alone has
// room for makes its beat alone: only there the deepest are chosen as they are for it.
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include <cca/sim/compiled/compiled_world.hpp>
#include <cca/sim/compiled/lanes/lanes.hpp>
#include <cca/sim/compiled/together/state_in_lanes.hpp>

namespace cca::sim::detail {

template <class R, int N>
class beat_in_lanes {
  using real = lanes<N>;
  using convert = state_in_lanes<R, N>;

public:
  using world = compiled_world<R>;
  struct lane {
    world* of = nullptr;
    std::span<const joint_law> laws{};
  };

  static bool go_together(const lane& a, const lane& b) {
    const auto &s = a.of->settings_, &t = b.of->settings_;
    if (s.steps_per_beat != t.steps_per_beat || s.engine.gravity != t.engine.gravity ||
        !(s.plausible == t.plausible) || !a.of->around_.goes_with(b.of->around_))
      return false;
    for (std::size_t c = 0; c < world::n; ++c) {
      if ((a.of->built_.drives[c].torque > 0) != (b.of->built_.drives[c].torque > 0)) return false;
      if (R::drives[c].cable.stiffness > 0 && follows(a, c) != follows(b, c)) return false;
    }
    return true;
  }

  // All go together; at most N.
  static void make(std::span<const lane> all) {
    typename convert::many state;
    surroundings_for<real> around;
    built_robot<R, real> built;
    for (int k = 0; k < N; ++k) {  // lanes without a world have the first one's again
      const lane& l = at(all, k);
      convert::take(state, k, l.of->state_, l.laws);
      around.take_lane(k, l.of->around_);
      built.take_lane(k, l.of->built_);
    }
    const robot_world_settings& settings = all[0].of->settings_;
    step_in_world<R, real> steps{settings, around, built, state};
    std::array<world_trouble, static_cast<std::size_t>(N)> troubles{};
    std::array<bool, static_cast<std::size_t>(N)> crowded{};
    steps.begin_beat();
    for (int i = 0; i < settings.steps_per_beat; ++i) {
      steps.make(i);
      note_crowded(state, crowded);
      if (state.trouble) note(state, settings, steps.seconds(), troubles);
    }
    steps.end_beat();
    for (std::size_t k = 0; k < all.size(); ++k) {
      world& w = *all[k].of;
      if (crowded[k]) {
        w.advance(all[k].laws);
        continue;
      }
      if (troubles[k]) {
        w.state_.trouble = troubles[k];
        continue;
      }
      convert::give(state, static_cast<int>(k), w.state_, all[k].laws);
      w.end_beat();
    }
  }

private:
  static const lane& at(std::span<const lane> all, int k) {
    const auto i = static_cast<std::size_t>(k);
    return all[i < all.size() ? i : 0];
  }
  // Whether the drive follows a position in this beat.
  static bool follows(const lane& l, std::size_t c) {
    const bool takes = c < l.laws.size() && l.laws[c].is_finite();
    return is_law_of_position(takes ? l.laws[c] : l.of->state_.drives.laws[c]);
  }

  // In which lanes a step has had more contacts than a world alone keeps, or may have lost one.
  static void note_crowded(const typename convert::many& state,
                           std::array<bool, static_cast<std::size_t>(N)>& crowded) {
    const std::size_t found = state.impulses.count;
    if (found <= convert::room_alone) return;
    for (std::size_t k = 0; k < crowded.size(); ++k) {
      double own = 0;
      for (const contact_account& a : state.contacts.of_lane[k]) own += a.contacts;
      if (own > static_cast<double>(convert::room_alone) || found == state.impulses.keys.size())
        crowded[k] = true;
    }
  }
  // In some lane the world can't be right: in which ones, and why.
  static void note(typename convert::many& state,
                   const robot_world_settings& settings,
                   double step,
                   std::array<world_trouble, static_cast<std::size_t>(N)>& troubles) {
    using motion = decltype(typename convert::one{}.motion);
    state.trouble = {};
    for (int k = 0; k < N; ++k)
      if (world_trouble& own = troubles[static_cast<std::size_t>(k)]; !own)
        own = trouble_of<R>(motion_of_lane<motion>(state.motion, k), settings.plausible, step);
  }
};

}  // namespace cca::sim::detail
