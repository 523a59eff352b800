// Whether a component fires in beat k: settled at compile time wherever its clock is known, else asked of its
// strategy.
#pragma once

#include <cca/runtime/observe.hpp>

namespace cca::detail {

template <clock Clock>
CCA_INLINE constexpr bool ticks(std::int64_t k) {
  if constexpr (Clock.never()) return false;
  else if constexpr (Clock.every_beat()) return true;
  else if constexpr (Clock.period == 1) return k >= Clock.first;
  else if constexpr (Clock.first < Clock.period)
    return static_cast<std::uint64_t>(k) % static_cast<std::uint64_t>(Clock.period) ==
           static_cast<std::uint64_t>(Clock.first);
  else return k >= Clock.first && (k - Clock.first) % Clock.period == 0;
}

// The state of a function whose clock is known only at run time, when its strategy is asked.
template <class Graph, int Call>
struct question {
  const beat_context<Graph>& b;
  const call_place& at;
  const last_firing& self;

  template <int Position>
  CCA_INLINE bool fresh() const {
    constexpr int input = input_at<Graph, Call, Position>;
    if constexpr (is_wired<Graph, input>)
      return input_reader<Graph, input>::is_fresh(b, index_of_source<Graph>(at, Position), self.last);
    else return false;
  }
  template <int... Position>
  CCA_INLINE bool any_fresh(std::integer_sequence<int, Position...>) const {
    return (fresh<Position>() || ... || any_observed());
  }
  template <int... Position>
  CCA_INLINE bool all_fresh(std::integer_sequence<int, Position...>) const {
    return ((!is_wired<Graph, input_at<Graph, Call, Position>> || fresh<Position>()) && ... &&
            (!has_observers(call_of<Graph, Call>) || any_observed()));
  }

  // All inputs hold arrived samples of one origin, later than what was seen in the last firing.
  template <int... Position>
  CCA_INLINE bool together(std::integer_sequence<int, Position...>) const {
    std::int64_t common = never;
    bool all = true;
    (join<Position>(common, all), ...);
    return all && common > self.oldest;
  }
  template <int Position>
  CCA_INLINE void join(std::int64_t& common, bool& all) const {
    constexpr int input = input_at<Graph, Call, Position>;
    if constexpr (is_wired<Graph, input>) {
      const auto origin = input_reader<Graph, input>::origin(b, index_of_source<Graph>(at, Position));
      if (common == never) common = origin;
      all = all && origin != never && origin == common;
    }
  }

  // Does an observer of this function listen to something fresh?
  CCA_INLINE bool any_observed() const {
    bool any = false;
    if constexpr (has_observers(call_of<Graph, Call>))
      for_each_observed<Graph, Call>(
          [&]<int Link>() { any = any || observed_output<Graph, Link>::arrived(b) > self.last; });
    return any;
  }
};

template <class Graph, int Call>
CCA_INLINE beat beat_of(std::int64_t k, const last_firing& self) {
  return {k, counts_of<Graph>.period, self.last < 0 ? 1 : k - self.last};
}

}  // namespace cca::detail
