// A beat has ended early, or was left out: notes which components of known clock it kept from firing.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include <cca/runtime/component_call.hpp>

namespace cca::detail {

template <class Graph>
struct may_miss_firings {
  static constexpr bool holds(std::size_t c) {
    return plan_of<Graph>.calls[c].may_miss && plan_of<Graph>.calls[c].own_clock.known();
  }
};

template <class Graph, int Call>
void note_missed_call(controller_state<Graph>& state, std::int64_t k, int turns) {
  constexpr const auto& c = call_of<Graph, Call>;
  constexpr int part = part_of_call_at<Graph, Call>, number = layout_of<Graph>.calls[Call].missed;
  if (c.rank < turns || !ticks<c.own_clock>(k)) return;
  std::int64_t since = c.own_clock.first;
  if constexpr (part >= 0) {
    if (state.parts[array_size(part)].rests) return;
    since = std::max(since, state.parts[array_size(part)].since);
  }
  if constexpr (c.unsteady) since = std::max(since, state.since);
  missed_firing& missed = state.missed[array_size(number)];
  std::int64_t beats = c.own_clock.period;
  if constexpr (runs_in_cycles<Graph>) beats = state.beats_since;
  if (const std::int64_t tick = k - c.own_clock.period; tick < since) {
    missed.last = -1;
    if constexpr (c.unsteady) {  // in another mode it may have fired
      const last_firing& kept = state.firings[layout_of<Graph>.calls[Call].firing];
      if (part < 0 || !kept.is_first) missed.last = kept.last;
    }
    missed.beats = k - missed.last;
  } else if (missed.in == tick) {
    missed.beats += beats;
  } else {
    missed.last = tick;
    missed.beats = beats;
  }
  missed.in = k;
  state.missed_until = std::max(state.missed_until, k + c.own_clock.period + 1);
}

// Of beat k, in which the calls of the first `turns` ranks had their turn. Not inlined: the beat would grow.
template <class Graph>
[[gnu::noinline]] void note_missed([[maybe_unused]] controller_state<Graph>& state,
                                   [[maybe_unused]] std::int64_t k,
                                   [[maybe_unused]] int turns) {
  [&]<int... Call>(std::integer_sequence<int, Call...>) {
    const int all[] = {0, (note_missed_call<Graph, Call>(state, k, turns), 0)...};
    (void)all;
  }(chosen<counts_of<Graph>.call_count, may_miss_firings<Graph>>{});
}

}  // namespace cca::detail
