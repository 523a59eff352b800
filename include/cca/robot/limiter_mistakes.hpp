// What a limiter can't keep, and the sentences that name it. Used by limiter.hpp.
// Errors: space.bad_limits, space.unknown_axis, rate.missing. Cost: constants; the sentences are compiled
// only where one is broken.
#pragma once

#include <cstddef>
#include <string_view>
#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/robot/command_limits.hpp>
#include <cca/space/messages/space_in_words.hpp>

namespace cca::detail {

constexpr void tell_limit(text& m, double limit) {
  if (limit > 1e15) m << "infinite";
  else if (limit < -1e15) m << "-infinite";
  else m << limit;
}

// "the limits of acceleration of the axis hip are 0 to 5"; false: none of this quantity is bad.
template <class Space, class Quantity>
constexpr bool tell_bad_limits(text& m, auto is_bad) {
  if constexpr (!std::is_void_v<Quantity>)
    for (std::size_t i = 0; i < limits_of<Space>::size; ++i) {
      const closed_range r = limits_of<Space>::template limits_by<Quantity>[i];
      if (!is_bad(r)) continue;
      m << "space.bad_limits: the limits of " << type_name<Quantity>() << " of the axis "
        << axis_in_words(typename Space::axes(), static_cast<int>(i)) << " are ";
      tell_limit(m, r.lower);
      m << " to ";
      tell_limit(m, r.upper);
      m << ", and a limiter of " << space_in_words<Space>();
      return true;
    }
  return false;
}

template <class Space>
struct must_always_move {
  static constexpr void tell(text& m) {
    (void)tell_bad_limits<Space, typename limits_of<Space>::rate_quantity>(
        m, [](closed_range r) { return !(r.lower <= 0 && r.upper >= 0); });
    m << " must be able to keep a command as it is: let them include 0";
  }
};
template <class Space>
struct cannot_turn_round {
  static constexpr void tell(text& m) {
    const auto is_bad = [](closed_range r) { return !(r.lower < 0 && r.upper > 0); };
    (void)(tell_bad_limits<Space, typename limits_of<Space>::second_quantity>(m, is_bad) ||
           tell_bad_limits<Space, typename limits_of<Space>::third_quantity>(m, is_bad));
    m << " must be able to stop an axis that has begun to move: let them be below and above 0";
  }
};
template <class Space>
struct limiter_without_rate {
  static constexpr void tell(text& m) {
    int axis = 0;
    while (!limits_of<Space>::is_bounded(static_cast<std::size_t>(axis))) ++axis;
    m << "rate.missing: the axis " << axis_in_words(typename Space::axes(), axis)
      << " limits how fast the rate of a command changes, for which a limiter of " << space_in_words<Space>()
      << " needs the time from one command to the next: give the space a rate, as cca::rate<1000>";
  }
};

struct unlimited_space : space<number, axes<x>> {};  // stands for one that is refused

template <class Space>
inline constexpr bool has_number_per_axis = Space::size == Space::axes::count;
template <class Space>
using kept_limits = limits_of<std::conditional_t<has_number_per_axis<Space>, Space, unlimited_space>>;

}  // namespace cca::detail
