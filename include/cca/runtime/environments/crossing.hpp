// What goes from one environment to another: outputs that are read there, with their delays.
#pragma once

#include <array>
#include <cstddef>

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

}  // namespace cca::detail
