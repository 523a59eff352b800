// Inverse kinematics of any serial chain: descents from many starts, a part of them in each beat.
//
// A descent ends in a minimum of the distance to the target, and there are several: a chain stretched towards
// its target has no direction to start in, and limits block the way. So the first descent begins at the given
// angles, and, if it does not reach the target, others begin at points spread evenly over the ranges of the
// joints, until one reaches it or `starts` of them have ended. Only then the target counts as out of reach,
// and the result is the nearest point of all.
//
// A beat takes at most `steps_per_beat` steps, at least a quarter of them for other starts. The search is
// kept for the next beat, where it goes on. A target that moves by more than `same_target` begins a new count
// of starts, but the starts go on from where they were, so a target that moves all the time is searched as
// well. Deterministic; nothing allocates.
//
// A target that is NaN or infinite does not come here: inverse_kinematics.hpp answers it. The search waits
// and goes on with the next target. Cost: a step of a pose of seven joints takes about 6,900 instructions, so
// a beat at most 0.7 million.
//
// Source of the starts: Roberts, The unreasonable effectiveness of quasirandom sequences, 2018: multiples of
// the powers of 1/g, where g^(n + 1) = g + 1. Checked: reachable poses of seven-joint arms are reached, and
// out of reach an independent optimiser finds no nearer point (tests/runtime/mapping/search.cpp).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/mapping/damped_least_squares.hpp>
#include <cca/mapping/reaching.hpp>

namespace cca {
namespace detail {

template <int Size>
constexpr std::array<double, static_cast<std::size_t>(Size)> spread_of_starts() {
  double g = 2;
  for (int i = 0; i < 60; ++i) {  // Newton's method
    double power = 1;
    for (int k = 0; k < Size; ++k) power *= g;
    g -= (power * g - g - 1) / ((Size + 1) * power - 1);
  }
  std::array<double, static_cast<std::size_t>(Size)> spread{};
  double part = 1;
  for (double& s : spread) s = part /= g;
  return spread;
}

template <class Settings>
struct too_little_search {
  static constexpr void tell(text& m) {
    m << "cca::inverse_kinematics: the settings " << type_name<Settings>() << " state " << Settings::starts
      << " starts, " << Settings::steps_per_beat << " steps per beat and " << Settings::iterations
      << " iterations: make them at least 1, 8 and 8";
  }
};

template <class Chain, class Joints, class Tip, class Settings>
class many_starts {
  static_assert(
      holds_or_tells<(Settings::starts >= 1 && Settings::steps_per_beat >= 8 && Settings::iterations >= 8),
                     too_little_search<Settings>>::value);
  using limits = chain_limits<Chain, Joints>;
  using wanted_type = typename Tip::vector_type;

public:
  using vector = typename limits::vector;
  struct answer {
    vector q;
    reaching status;
    int steps;  // taken in this beat
  };

  // One beat. Preconditions: `wanted` passed readable(), `near` lies within the limits.
  answer solve(const wanted_type& wanted, const vector& near) {
    if (!searching || !is_same(wanted)) begin(wanted, near);
    else if (wanted != last_wanted) go_on();
    last_wanted = wanted;

    int left = Settings::steps_per_beat;
    if (best.running()) left -= best.run(wanted, left - left / 4);
    while (!best.reached() && ended < Settings::starts && left > 0) {
      if (!other.running()) other.begin(start(next_start++));
      left -= other.run(wanted, left, best.square);
      if (other.running()) break;
      ++ended;
      if (other.reached() || math::sqrt(other.square) < math::sqrt(best.square) - 1e-6 * limits::span) {
        best = other;
        if (best.exhausted()) best.go_on();
      }
    }

    const int steps = Settings::steps_per_beat - left;
    if (!best.reached()) {
      const bool all = ended >= Settings::starts && !best.running();
      return {best.q, all ? reaching::nearest : reaching::unfinished, steps};
    }
    searching = false;
    next_start = 0;
    other = {};
    return {best.q, reaching::reached, steps};
  }

  // m, from the tip at the last answer to the target.
  double distance() const { return math::sqrt(best.square); }

private:
  // m: a target that moves less keeps the search. The distance to the nearest point changes by no more.
  static constexpr double same_target = 0.25e-3;

  descent<Chain, Joints, Tip, Settings> best, other;
  wanted_type first_wanted = wanted_type::Zero(), last_wanted = wanted_type::Zero();
  std::int64_t next_start = 0;
  int ended = 0;
  bool searching = false;

  void begin(const wanted_type& wanted, const vector& near) {
    first_wanted = wanted;
    searching = true;
    ended = 1;
    best.begin(near);
    if (other.running()) other.go_on();
  }
  void go_on() {
    best.go_on();
    if (other.running()) other.go_on();
  }

  bool is_same(const wanted_type& wanted) const {
    double moved = 0;
    if constexpr (!same_kind<typename Tip::domain, orientation<void>>) {
      constexpr int size = same_kind<typename Tip::domain, pose<void>> ? 3 : Tip::size;
      moved += math::norm(wanted.template head<size>() - first_wanted.template head<size>());
    }
    if constexpr (!same_kind<typename Tip::domain, cartesian_position<void>>) {
      const vector4 a = wanted.template tail<4>(), b = first_wanted.template tail<4>();
      moved += 2 * Settings::lever * std::min(math::norm(a - b), math::norm(a + b));
    }
    return moved <= same_target;
  }

  // The first is the middle of the ranges. Of the others every second one has two thirds of its joints at
  // their limits: there lie the nearest points of many targets out of reach.
  static vector start(std::int64_t number) {
    static constexpr auto spread = spread_of_starts<limits::size>();
    vector q;
    for (int i = 0; i < limits::size; ++i) {
      double part = 0.5 + static_cast<double>(number) * spread[static_cast<std::size_t>(i)];
      part -= math::floor(part);
      if (number % 2 != 0) part = std::clamp(3 * part - 1, 0.0, 1.0);
      q[i] = limits::between(i, part);
    }
    return q;
  }
};

}  // namespace detail
}  // namespace cca
