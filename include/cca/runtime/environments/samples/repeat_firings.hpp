// A function whose clock is known in the whole architecture counts as fired in a beat that was cut, as in one
// loop, also where its clock is not known in the part of its environment. So do its outputs count as
// published.
#pragma once

#include <cstdint>
#include <type_traits>
#include <utility>

#include <cca/runtime/environments/crossing.hpp>

namespace cca::detail {

template <class D, int E, class State>
bool is_started_in([[maybe_unused]] const State& state,
                   [[maybe_unused]] const call& c,
                   [[maybe_unused]] std::int64_t beat) {
  if constexpr (parts_kept<part<D, E>> > 0) {
    const int part = plan_of<D>.nodes[array_size(c.node)].part;
    return part < 0 || (!state.parts[array_size(part)].rests && state.parts[array_size(part)].since <= beat);
  }
  return true;
}

template <class D, int E, class State>
void repeat_firings([[maybe_unused]] State& state, [[maybe_unused]] std::int64_t beat) {
  if constexpr (layout_of<part<D, E>>.firing_count > 0)
    for (std::size_t c = 0; c < array_size(counts_of<D>.call_count); ++c)
      if (const int at = layout_of<part<D, E>>.calls[c].firing;
          at >= 0 && is_started_in<D, E>(state, plan_of<D>.calls[c], beat) &&
          ticks(plan_of<D>.calls[c].own_clock, beat)) {
        state.firings[at].last = beat;
        state.firings[at].is_first = false;
      }
}

template <class D, int E>
struct is_kept_by_whole {
  static constexpr bool holds(std::size_t o) {
    const auto& whole = plan_of<D>;
    const auto& own = plan_of<part<D, E>>;
    const flat_view g = whole.view();
    const output& out = own.outputs[o];
    return environment_of(g, out.call) == E &&
           (out.storage == storage_kind::past || out.storage == storage_kind::newest) &&
           published(g, g.outputs[o]).known() && stored_clock(own.view(), out).dynamic();
  }
};
// `index`: the beat, as the loop of the environment counts it.
template <class D, int E, class State>
void repeat_publications([[maybe_unused]] State& state,
                         [[maybe_unused]] std::int64_t beat,
                         [[maybe_unused]] std::int64_t index) {
  [&]<int... Output>(std::integer_sequence<int, Output...>) {
    [[maybe_unused]] const auto repeat = [&]<int One>(std::integral_constant<int, One>) {
      constexpr place at = layout_of<part<D, E>>.outputs[One];
      if (ticks(published_of<D, One>, beat)) sample_in<part<D, E>, at.array>(state, at.index).repeat(index);
    };
    (repeat(std::integral_constant<int, Output>{}), ...);
  }(chosen<counts_of<D>.output_count, is_kept_by_whole<D, E>>{});
}

// In a deployment of modes the clocks of a part are those of the whole.
template <class D, int E, class State>
void repeat_by_whole([[maybe_unused]] State& state,
                     [[maybe_unused]] std::int64_t beat,
                     [[maybe_unused]] std::int64_t index) {
  if constexpr (!DeployedMode<D>) {
    repeat_firings<D, E>(state, beat);
    repeat_publications<D, E>(state, beat, index);
  }
}

}  // namespace cca::detail
