// The limiter: no command reaches an actuator without passing one (robot.unlimited_command).
//
//   cca::node<"limits", cca::limiter<leg_angles>>      in "command", optional "measured"; out "safe"
//
// What it publishes is finite and lies within the limits that its axes state for the domain type's own
// quantity, always. Besides, it changes from one safe command to the next at most as fast as the axes allow:
// an angle by their `velocity`, a velocity by `acceleration`, a torque by `torque_rate`, an axis that states
// none at will. Each number is checked for
//
//   finite   NaN and infinity are no commands: the quantity's `on_nan` says whether the last safe command is
//            held (an angle, a stiffness) or the allowed number nearest to zero is published (a velocity, a
//            torque);
//   range    else the nearest allowed number is published;
//   rate     and of the allowed numbers the nearest that can be reached since the last safe command, in at
//            most one period of the space's rate: after a pause a command may not jump.
//
// It starts from "measured", if that is wired and a sample has arrived, and holds it until the first command;
// else it takes the first command as it is. It counts each number that it changes, and keeps the first cause:
// which axis, which check, in which beat: `summary()` says so after a run.
//
// Cost: two comparisons an axis and one branch; two additions more in a space that limits a rate. The rest
// runs only when a command is changed. Errors: space.missing_limits. Example:
// tests/runtime/robot/limiter.cpp; docs/robot.md.
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

namespace detail {

// The quantity that limits how fast another one may change.
template <class Quantity>
struct rate_of_quantity {
  using type = void;
};
template <>
struct rate_of_quantity<angle> {
  using type = velocity;
};
template <>
struct rate_of_quantity<velocity> {
  using type = acceleration;
};
template <>
struct rate_of_quantity<torque> {
  using type = torque_rate;
};

// `a` where the comparison is false, so also where `b` is NaN: one instruction each.
constexpr double at_least(double a, double b) { return b > a ? b : a; }
constexpr double at_most(double a, double b) { return b < a ? b : a; }

// The limits of one space as arrays: range and rate.
template <class Space>
struct limits_of {
  static constexpr std::size_t size = Space::size;
  using quantity = typename Space::domain::quantity;
  using rate_quantity = typename rate_of_quantity<quantity>::type;
  struct bounds {
    double lower, upper;
  };

  // An axis without limits has those of a double, so that infinity lies outside in any case.
  static constexpr std::array<bounds, size> range = [] {
    std::array<bounds, size> all{};
    constexpr double largest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < size; ++i)
      all[i] = {at_least(-largest, lower_limits<Space, quantity>[i]),
                at_most(largest, upper_limits<Space, quantity>[i])};
    return all;
  }();

  static constexpr std::array<bounds, size> rate = [] {
    std::array<bounds, size> all{};
    for (std::size_t i = 0; i < size; ++i) {
      if constexpr (std::is_void_v<rate_quantity>)
        all[i] = {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
      else all[i] = {lower_limits<Space, rate_quantity>[i], upper_limits<Space, rate_quantity>[i]};
    }
    return all;
  }();

  static constexpr bool has_any_rate = [] {
    constexpr double all = std::numeric_limits<double>::infinity();
    for (const auto& r : rate)
      if (r.lower > -all || r.upper < all) return true;
    return false;
  }();
  static constexpr bool may_rest = [] {
    for (const auto& r : rate)
      if (!(r.lower <= 0 && r.upper >= 0)) return false;
    return true;
  }();

  static constexpr double in_range(int axis, double value) {
    const auto i = static_cast<std::size_t>(axis);
    return at_most(range[i].upper, at_least(range[i].lower, value));
  }

  // The range, and of it what can be reached from the last number within dt: all of it where the rate is
  // infinite, also in no time, since `at_least` and `at_most` pass over the NaN of infinity * 0.
  static constexpr bounds window(int axis, double last, double dt) {
    const auto i = static_cast<std::size_t>(axis);
    if constexpr (!has_any_rate) return range[i];
    return {at_least(range[i].lower, last + rate[i].lower * dt),
            at_most(range[i].upper, last + rate[i].upper * dt)};
  }
};

}  // namespace detail

template <class Space>
class limiter {
  static_assert(Space::size == Space::axes::count,
                "cca::limiter: this domain type has no number per axis, and so no limits");
  static_assert(__FINITE_MATH_ONLY__ == 0,
                "cca::limiter: -ffinite-math-only (of -ffast-math) would let NaN pass to the actuators");
  using limits = detail::limits_of<Space>;
  static_assert(limits::may_rest, "cca::limiter: the limits of how fast a command may change must include 0");

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
      if (first.cause == limited_by::nothing)
        first = {lost                                                               ? limited_by::finite
                 : limits::has_any_rate && limits::in_range(axis, wanted) == wanted ? limited_by::rate
                                                                                    : limited_by::range,
                 axis, k};
    });
    return value;
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
};

// Lets commands pass as they are, NaN too: the way to switch the limiter off, where all can see it.
template <class Space>
struct unlimited {
  static constexpr bool limits_commands = true;
  auto process(in<"command", Space> command) -> out<"safe", Space> { return command; }
};

}  // namespace cca
