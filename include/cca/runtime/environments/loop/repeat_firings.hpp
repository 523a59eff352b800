// A function whose clock is known in the whole architecture fires next when this clock says so, also after a
// beat that was cut and where its clock is not known in the part of its environment: for that it counts as
// fired, and it is noted when it really did. So do its outputs count as published.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <cca/runtime/environments/exchange/crossing.hpp>

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
    for (std::size_t c = 0; c < array_size(counts_of<D>.call_count); ++c) {
      const call_place& at = layout_of<part<D, E>>.calls[c];
      const call& of_whole = plan_of<D>.calls[c];
      if (at.firing < 0 || !is_started_in<D, E>(state, of_whole, beat) || !ticks(of_whole.own_clock, beat))
        continue;
      last_firing& own = state.firings[at.firing];
      const int in_part = plan_of<D>.nodes[array_size(of_whole.node)].part;
      const bool has_fired = own.last >= 0 && (in_part < 0 || !own.is_first);
      if (has_fired && own.last == beat) continue;
      if constexpr (layout_of<part<D, E>>.missed_count > 0)
        if (at.missed >= 0) {
          missed_firing& missed = state.missed[array_size(at.missed)];
          if (!has_fired || missed.in != own.last) missed.last = has_fired ? own.last : -1;
          missed.in = beat;
          missed.beats = beat - missed.last;
          state.missed_until = std::max(state.missed_until, beat + of_whole.own_clock.period + 1);
        }
      own.last = beat;
      own.is_first = false;
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
           published(g, g.outputs[o]).known() && published(own.view(), out).dynamic();
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

// In a deployment of modes a part fires by the clocks of the whole.
template <class D, int E, class State>
void repeat_by_whole([[maybe_unused]] State& state,
                     [[maybe_unused]] std::int64_t beat,
                     [[maybe_unused]] std::int64_t index) {
  if constexpr (!DeployedMode<D>) repeat_firings<D, E>(state, beat);
  repeat_publications<D, E>(state, beat, index);
}

}  // namespace cca::detail
