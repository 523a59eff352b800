// What goes from one environment to another: outputs that are read there, with their delays.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <cca/graph/plan/deployment/part.hpp>
#include <cca/runtime/state.hpp>

namespace cca::detail {

template <class D>
struct crossings {
  // For each output, the largest delay of a reader in another environment; 0: all readers are here.
  std::array<int, array_size(graph_size<D>.outputs) + 1> largest_delay{};
  // From an environment to another the least delay; 0: nothing goes there.
  std::array<std::array<int, array_size(environment_count<D>)>, array_size(environment_count<D>)>
      least_delay{};
};

template <class D>
inline constexpr auto crossings_of = [] {
  crossings<D> found;
  auto plan = plan_of<D>;
  const flat_view g = plan.view();
  for (int o = 0; o < g.output_count; ++o) {
    const int from = environment_of(g, g.outputs[o].call);
    for_each_reader(g, o, [&](int to, int delay) {
      if (to == from) return;
      int& largest = found.largest_delay[array_size(o)];
      int& least = found.least_delay[array_size(from)][array_size(to)];
      if (delay > largest) largest = delay;
      if (least == 0 || delay < least) least = delay;
    });
  }
  return found;
}();

template <class D>
struct leaves_environment {
  static constexpr bool holds(std::size_t o) { return crossings_of<D>.largest_delay[o] > 0; }
};

template <class D, int E>
struct leaves_by_clock {
  static constexpr bool holds(std::size_t o) {
    auto plan = plan_of<D>;
    return crossings_of<D>.largest_delay[o] > 0 && environment_of(plan.view(), plan.outputs[o].call) == E &&
           published(plan.view(), plan.outputs[o]).known();
  }
};

// Whoever has all samples of an environment's outputs up to a beat knows that it has done the beat: they are
// published by known clocks, and it can't fault behind them. `Output`: those whose samples are seen.
template <class D, int E, int... Output>
inline constexpr bool samples_tell = [] {
  auto plan = plan_of<D>;
  const flat_view g = plan.view();
  return !counts_of<part<D, E>>.may_fault &&
         ((environment_of(g, g.outputs[Output].call) != E || published(g, g.outputs[Output]).known()) && ...);
}();

// The outputs that an environment reads from others.
template <class Part>
struct arrives {
  static constexpr bool holds(std::size_t o) {
    return plan_of<Part>.outputs[o].storage == storage_kind::arriving;
  }
};

// How many beats an environment may be ahead of those that read from it, and of the first one, as fast as
// possible. More than that smooths nothing: the samples of a ring stay in the caches while it is short.
template <class D>
inline constexpr std::int64_t most_ahead = 4 + std::min(std::ranges::max(crossings_of<D>.largest_delay), 16);

// The samples that an environment waits for before a beat prove that their writer is at most `most_ahead`
// beats behind. So the environment need not read the writer's position.
template <class D, int From, int To>
inline constexpr bool samples_show_progress = [] {
  return []<int... Output>(std::integer_sequence<int, Output...>) {
    auto plan = plan_of<D>;
    const flat_view g = plan.view();
    const int delay = crossings_of<D>.least_delay[From][To];
    [[maybe_unused]] const auto shows = [&](const output& from) {
      const clock ticks = published(g, from);
      return environment_of(g, from.call) == From && ticks.known() &&
             ticks.first + delay <= most_ahead<D> + 1 && ticks.period - 1 + delay <= most_ahead<D>;
    };
    return samples_tell<D, From, Output...> && (shows(plan.outputs[Output]) || ...);
  }(chosen<counts_of<D>.output_count, arrives<part<D, To>>>{});
}();

// Those that write to an environment, and all if it is the first, see from its samples how far it is.
template <class D, int From>
inline constexpr bool samples_show_progress_to_all = []<int... To>(std::integer_sequence<int, To...>) {
  return ((To == From || (crossings_of<D>.least_delay[To][From] == 0 && From != 0) ||
           samples_show_progress<D, From, To>) &&
          ...);
}(std::make_integer_sequence<int, environment_count<D>>{});

}  // namespace cca::detail
