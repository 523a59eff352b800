// The limiter: no command reaches an actuator without passing one (robot.unlimited_command).
//
//   cca::node<"limits", cca::limiter<leg_angles>>      in "command", optional "measured"; out "safe"
//
// What it publishes is finite and lies within the limits that its axes state for the domain type's own
// quantity, always. Besides, it changes from one safe command to the next at most as fast as the axes allow:
// an angle by their `velocity`, a velocity by `acceleration`, an acceleration by `jerk`, a torque by
// `torque_rate`, an axis that states none at will. And this change changes by the next one of these: the
// angle of an axis that states `acceleration` or `jerk` starts, turns round and stops within them, and stops
// before the end of its range (bounded_motion.hpp). Each number is checked for
//
//   finite   NaN and infinity are no commands: the quantity's `on_nan` says whether the last safe command is
//            held (an angle, a stiffness) or the allowed number nearest to zero is published (a velocity, a
//            torque);
//   range    else the nearest allowed number is published;
//   rate     and of the allowed numbers the nearest that can be reached since the last safe command, in at
//            most one period of the space's rate: after a pause a command may not jump. Where also the
//            change is limited, a command that keeps the limits passes, and others are reached in the
//            shortest time that leaves room to brake; a command that is no number is a command to brake.
//
// The angle of a continuous axis is published as the one that means the same as the command and is nearest to
// the last safe one, so it never jumps by a turn.
//
// It starts from "measured", if that is wired and a sample has arrived, and holds it until the first command;
// else it takes the first command as it is. It counts each number that it changes, and keeps the first cause:
// which axis, which check, in which beat: `summary()` says so after a run.
//
// Cost: two comparisons an axis and one branch; two additions more in a space that limits a rate. The rest
// runs only when a command is changed. In a space that also limits the change of the rate: that of
// bounded_motion.hpp. Errors: space.missing_limits,
// space.bad_limits, space.unknown_axis, rate.missing. Example: tests/runtime/robot/limiter.cpp;
// docs/robot.md.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>

#include <cca/base/after_run.hpp>
#include <cca/component/beat.hpp>
#include <cca/base/unrolled.hpp>
#include <cca/component/port.hpp>
#include <cca/robot/bounded_motion.hpp>
#include <cca/robot/command_limits.hpp>
#include <cca/robot/limiter_mistakes.hpp>
#include <cca/space/domain.hpp>
#include <cca/space/info.hpp>
#include <cca/space/limits.hpp>

namespace cca {

enum class limited_by : std::uint8_t { nothing, finite, range, rate };

// Why and where a command was changed first.
struct intervention {
  limited_by cause = limited_by::nothing;
  int axis = -1;
  std::int64_t beat = -1;
};

template <class Space>
class limiter {
  static_assert(__FINITE_MATH_ONLY__ == 0,
                "cca::limiter: -ffinite-math-only (of -ffast-math) would let NaN pass to the actuators");
  using limits = detail::kept_limits<Space>;
  static_assert(
      detail::holds_or_tells<detail::has_number_per_axis<Space>, detail::no_number_per_axis<Space>>::value);
  static_assert(detail::holds_or_tells<limits::may_rest, detail::must_always_move<Space>>::value);
  static_assert(detail::holds_or_tells<limits::may_turn_round, detail::cannot_turn_round<Space>>::value);
  static_assert(detail::holds_or_tells<(!limits::has_any_second || detail::hz_of<typename Space::rate> > 0),
                                       detail::limiter_without_rate<Space>>::value);

public:
  static constexpr bool limits_commands = true;
  using vector_type = typename Space::vector_type;

  auto process(in<"command", Space> command, optional_in<"measured", Space> measured, beat now)
      -> out<"safe", Space> {
    if ((limits::has_any_rate || measured) && !begun) [[unlikely]] {
      begin(command.vector(), measured.vector(), measured && measured.origin() != never,
            command.fresh() || !measured);
      if (!begun) return last;
    }
    const double dt = time_since(now);
    vector_type value;
    bool changed = false;
    if constexpr (detail::has_continuous_angles<Space>) return limited(command.vector(), now.index(), dt);
    if constexpr (limits::has_any_second) return limited(command.vector(), now.index(), dt);
    detail::unrolled<Space::size>([&](auto axis) {
      const auto [low, high] = limits::window(axis, last[axis], dt);
      const double wanted = command.vector()[axis];
      value[axis] = detail::at_most(high, detail::at_least(low, wanted));
      changed |= value[axis] != wanted;
    });
    if (changed) [[unlikely]]
      value = corrected(command.vector(), now.index(), dt);
    last = value;
    return value;
  }

  void on_start() { *this = {}; }

  // Numbers changed since the start.
  std::int64_t interventions() const { return count; }
  intervention first_intervention() const { return first; }
  std::string summary() const {
    if (count == 0) return {};
    constexpr const char* reasons[] = {"", "it was not finite", "its range", "its rate"};
    return detail::formatted("%lld numbers limited; the first: `%.*s` in beat %lld: %s",
                             static_cast<long long>(count),
                             static_cast<int>(detail::space_of<Space>.labels[first.axis].size()),
                             detail::space_of<Space>.labels[first.axis].data(),
                             static_cast<long long>(first.beat), reasons[static_cast<int>(first.cause)]);
  }

private:
  // By value, here and below: a reference to what is seldom looked at would keep it in memory in each beat.
  [[gnu::always_inline]] void begin(vector_type command, vector_type measured, bool is_measured, bool now) {
    detail::rolled<Space::size>([&](int axis) {
      const double there = measured[axis], wanted = command[axis];
      const double start = is_measured && std::isfinite(there) ? there : std::isfinite(wanted) ? wanted : 0;
      last[axis] = limits::in_range(axis, start);
      if constexpr (limits::has_any_second) motions[static_cast<std::size_t>(axis)].rest_at(last[axis]);
    });
    begun = now;
  }

  static double time_since(const beat& now) {
    if constexpr (detail::hz_of<typename Space::rate> > 0)
      return detail::at_most(1 / detail::hz_of<typename Space::rate>, now.dt());
    else return now.dt();
  }

  // Limits again, and records what the status reports.
  [[gnu::always_inline]] vector_type corrected(vector_type value, std::int64_t k, double dt) {
    detail::rolled<Space::size>([&](int axis) {
      const double wanted = value[axis];
      const auto [low, high] = limits::window(axis, last[axis], dt);
      if (wanted >= low && wanted <= high) return;
      const bool lost = !std::isfinite(wanted);
      const double goal = !lost ? wanted : limits::quantity::on_nan == nan_policy::hold ? last[axis] : 0;
      value[axis] = detail::at_most(high, detail::at_least(low, goal));
      ++count;
      if (first.cause == limited_by::nothing) first = {cause_of(wanted, lost, axis), axis, k};
    });
    return value;
  }

  // The same where angles have no end, or the change of the rate is limited.
  vector_type limited(vector_type value, std::int64_t k, double dt) {
    for (int axis = 0; axis < Space::size; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      double wanted = value[axis];
      if (detail::continuous_along<Space>[i] && std::isfinite(wanted))
        wanted = detail::same_turn(wanted, last[axis]);
      const bool lost = !std::isfinite(wanted), holds = lost && limits::quantity::on_nan == nan_policy::hold;
      const double goal = holds ? last[axis] : lost ? 0 : wanted;
      const auto [low, high] = limits::window(axis, last[axis], dt);
      value[axis] = detail::at_most(high, detail::at_least(low, goal));
      if constexpr (limits::has_any_second)
        if (limits::is_bounded(i))
          value[axis] =
              holds ? motions[i].brake(most[i]) : motions[i].go_to(limits::in_range(axis, goal), most[i]);
      if (value[axis] == wanted) continue;
      ++count;
      if (first.cause == limited_by::nothing) first = {cause_of(wanted, lost, axis), axis, k};
    }
    return last = value;
  }

  [[gnu::always_inline]] static limited_by cause_of(double wanted, bool lost, int axis) {
    return lost                                                               ? limited_by::finite
           : limits::has_any_rate && limits::in_range(axis, wanted) == wanted ? limited_by::rate
                                                                              : limited_by::range;
  }

  static vector_type rest() {
    vector_type nearest_to_zero;
    detail::unrolled<Space::size>([&](auto axis) { nearest_to_zero[axis] = limits::in_range(axis, 0); });
    return nearest_to_zero;
  }

  vector_type last = rest();
  bool begun = false;
  std::int64_t count = 0;
  intervention first{};

  struct nothing {};
  static constexpr std::array<detail::motion_limits, Space::size> most = [] {
    std::array<detail::motion_limits, Space::size> all{};
    if constexpr (limits::has_any_second)
      for (std::size_t i = 0; i < Space::size; ++i) all[i] = limits::a_beat(i);
    return all;
  }();
  [[no_unique_address]] std::conditional_t<limits::has_any_second,
                                           std::array<detail::bounded_motion, Space::size>,
                                           nothing> motions{};
};

// Lets commands pass as they are, NaN too: the way to switch the limiter off, where all can see it.
template <class Space>
struct unlimited {
  static constexpr bool limits_commands = true;
  auto process(in<"command", Space> command) -> out<"safe", Space> { return command; }
};

}  // namespace cca
