// What a limiter keeps the commands of a space within: their range, how fast they may change, and, where the
// axes say so, how fast that may change. Used by limiter.hpp. Cost: constants.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <type_traits>

#include <cca/robot/bounded_motion.hpp>
#include <cca/space/domain.hpp>
#include <cca/space/limits.hpp>

namespace cca {

namespace detail {

// The quantity that limits how fast another one may change; void: nothing does.
template <class Quantity>
struct rate_of_quantity {
  using type = void;
};
template <class Quantity>
  requires requires { typename Quantity::rate; }
struct rate_of_quantity<Quantity> {
  using type = typename Quantity::rate;
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
  using second_quantity = typename rate_of_quantity<rate_quantity>::type;
  using third_quantity = typename rate_of_quantity<second_quantity>::type;
  using bounds = closed_range;

  // An axis without limits has those of a double, so that infinity lies outside in any case.
  static constexpr std::array<bounds, size> range = [] {
    std::array<bounds, size> all{};
    constexpr double largest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < size; ++i)
      all[i] = {at_least(-largest, lower_limits<Space, quantity>[i]),
                at_most(largest, upper_limits<Space, quantity>[i])};
    return all;
  }();

  // Of the quantity by which this one changes, or of that by which the rate does.
  template <class Rate>
  static constexpr std::array<bounds, size> limits_by = [] {
    std::array<bounds, size> all{};
    for (std::size_t i = 0; i < size; ++i) {
      if constexpr (std::is_void_v<Rate>)
        all[i] = {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
      else all[i] = {lower_limits<Space, Rate>[i], upper_limits<Space, Rate>[i]};
    }
    return all;
  }();
  static constexpr auto& rate = limits_by<rate_quantity>;

  static constexpr bool bounds_any(const std::array<bounds, size>& all) {
    constexpr double most = std::numeric_limits<double>::infinity();
    for (const auto& r : all)
      if (r.lower > -most || r.upper < most) return true;
    return false;
  }
  static constexpr bool has_any_rate = bounds_any(rate);
  static constexpr bool has_any_second =
      bounds_any(limits_by<second_quantity>) || bounds_any(limits_by<third_quantity>);
  // Of an axis that limits the change of its rate, per beat of the space.
  static constexpr bool is_bounded(std::size_t i) {
    constexpr double most = std::numeric_limits<double>::infinity();
    const auto bounds_it = [](bounds r) { return r.lower > -most || r.upper < most; };
    return bounds_it(limits_by<second_quantity>[i]) || bounds_it(limits_by<third_quantity>[i]);
  }
  static constexpr motion_limits a_beat(std::size_t i) {
    const double dt = 1.0 / hz_of<typename Space::rate>;
    const auto scaled = [](bounds r, double by) { return bounds{r.lower * by, r.upper * by}; };
    bounds third = limits_by<third_quantity>[i];
    // One that is stated for one direction alone holds for both.
    if (third.lower < -1e300 && third.upper < 1e300) third.lower = -third.upper;
    if (third.upper > 1e300 && third.lower > -1e300) third.upper = -third.lower;
    return {range[i], scaled(rate[i], dt), scaled(limits_by<second_quantity>[i], dt * dt),
            scaled(third, dt * dt * dt)};
  }
  static constexpr bool may_turn_round = [] {
    for (std::size_t i = 0; i < size; ++i)
      for (const bounds& r : {limits_by<second_quantity>[i], limits_by<third_quantity>[i]})
        if (!(r.lower < 0 && r.upper > 0)) return false;
    return true;
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

}  // namespace cca
