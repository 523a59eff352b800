// A beat that a fault cuts, or that an environment skips, counts as done: an output whose clock is known
// counts as published in it, with its last sample. The readers of later beats rely on that clock.
// A component of known clock that it kept from firing is noted: its next dt() is longer.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include <cca/runtime/component_call.hpp>

namespace cca::detail {

template <class Graph>
struct is_kept_by_clock {
  static constexpr bool holds(std::size_t o) {
    const auto& plan = plan_of<Graph>;
    const auto& out = plan.outputs[o];
    const bool is_kept =
        out.storage == storage_kind::past || (out.storage == storage_kind::newest && !out.by_clock);
    return is_kept && published(plan.view(), out).known();
  }
};

template <class Graph, int Output>
void repeat_output(controller_state<Graph>& state, std::int64_t k) {
  constexpr place at = layout_of<Graph>.outputs[Output];
  if (output_of<Graph, Output>.by_clock || ticks(published_of<Graph, Output>, k))
    sample_in<Graph, at.array>(state, at.index).repeat(k);
}

// What should have been published in beat k and was not.
template <class Graph>
void repeat_outputs([[maybe_unused]] controller_state<Graph>& state, [[maybe_unused]] std::int64_t k) {
  [&]<int... Output>(std::integer_sequence<int, Output...>) {
    const int all[] = {0, (repeat_output<Graph, Output>(state, k), 0)...};
    (void)all;
  }(chosen<counts_of<Graph>.output_count, is_kept_by_clock<Graph>>{});
}

// ---- what was kept from firing ----

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
