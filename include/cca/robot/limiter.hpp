// The limiter: no command reaches an actuator without passing one (robot.unlimited_command).
//
//   cca::node<"limits", cca::limiter<leg_angles>>      in "command", optional "measured"; out "safe"
//
// Each axis, in this order:
//   finite   what is NaN or infinite is replaced by the last safe command (before there is one: by the measured value
//            where that is wired and finite, else by the value within the limits that is nearest to zero);
//   rate     the change since the last safe command is at most the axis's limit of the derived quantity (an angle's
//            velocity, a velocity's acceleration, a torque's torque_rate) times the time since, if it states one; the
//            first command is measured against "measured", where that is wired;
//   range    the limits of the domain's own quantity, which every axis has to state (space.missing_limits).
// Every intervention is counted, and the first cause kept: which axis, which of the three, in which beat.
//
// Cost: a few comparisons an axis; no branch that depends on the values but for the count.
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <cca/component/beat.hpp>
#include <cca/component/port.hpp>
#include <cca/space/domain.hpp>
#include <cca/space/limits.hpp>

namespace cca {

enum class limited_by : std::uint8_t { nothing, finite, rate, range };

namespace detail {

// The quantity that limits how fast another one may change; `void`: none does.
template <class Quantity> struct rate_quantity { using type = void; };
template <> struct rate_quantity<angle> { using type = velocity; };
template <> struct rate_quantity<velocity> { using type = acceleration; };
template <> struct rate_quantity<torque> { using type = torque_rate; };

}  // namespace detail

// Why and where a command was changed first.
struct intervention {
  limited_by cause = limited_by::nothing;
  int axis = -1;
  std::int64_t beat = -1;
};

template <class Space>
class limiter {
public:
  static constexpr bool limits_commands = true;

  using quantity = typename Space::domain::quantity;
  using rate_quantity = typename detail::rate_quantity<quantity>::type;
  using vector_type = typename Space::vector_type;

  auto process(in<"command", Space> command, optional_in<"measured", Space> measured, beat now) -> out<"safe", Space> {
    vector_type value;
    each([&](auto axis) { value[axis] = limit<axis>(command.vector()[axis], measured, now); });
    last = value;
    begun = true;
    return value;
  }

  void on_start() {
    begun = false;
    count = 0;
    first = {};
  }

  // Commands changed since the start, counted by axis and beat.
  std::int64_t interventions() const { return count; }
  intervention first_intervention() const { return first; }

private:
  template <int Axis, class Measured>
  double limit(double wanted, const Measured& measured, const beat& now) {
    constexpr double lower = detail::lower_limits<Space, quantity>[Axis], upper = detail::upper_limits<Space, quantity>[Axis];
    constexpr double rest = lower > 0 ? lower : upper < 0 ? upper : 0;
    limited_by cause = limited_by::nothing;

    const bool has_measured = measured && std::isfinite(measured.vector()[Axis]);
    const double from = begun ? last[Axis] : has_measured ? measured.vector()[Axis] : rest;
    double value = wanted;
    if (!std::isfinite(value)) {
      value = from;
      cause = limited_by::finite;
    }
    if constexpr (limits_rate<Axis>()) {
      if (begun || has_measured) {
        const double low = from + detail::lower_limits<Space, rate_quantity>[Axis] * now.dt();
        const double high = from + detail::upper_limits<Space, rate_quantity>[Axis] * now.dt();
        const double kept = value < low ? low : value > high ? high : value;
        if (kept != value && cause == limited_by::nothing) cause = limited_by::rate;
        value = kept;
      }
    }
    const double kept = value < lower ? lower : value > upper ? upper : value;
    if (kept != value && cause == limited_by::nothing) cause = limited_by::range;
    if (cause != limited_by::nothing) {
      ++count;
      if (first.cause == limited_by::nothing) first = {cause, Axis, now.index()};
    }
    return kept;
  }

  template <int Axis>
  static constexpr bool limits_rate() {
    if constexpr (std::is_void_v<rate_quantity>) return false;
    else return std::isfinite(detail::lower_limits<Space, rate_quantity>[Axis]) && std::isfinite(detail::upper_limits<Space, rate_quantity>[Axis]);
  }

  template <class F>
  static void each(F f) {
    [&]<int... Axis>(std::integer_sequence<int, Axis...>) { (f(std::integral_constant<int, Axis>{}), ...); }(std::make_integer_sequence<int, Space::size>{});
  }

  vector_type last = vector_type::Zero();
  bool begun = false;
  std::int64_t count = 0;
  intervention first{};
};

// Lets commands pass as they are: the way to switch the limiter off, where all can see it.
template <class Space>
struct unlimited {
  static constexpr bool limits_commands = true;
  auto process(in<"command", Space> command) -> out<"safe", Space> { return command; }
};

}  // namespace cca
