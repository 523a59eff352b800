// One beat of a graph: every call in its order, with the samples of the beat as locals.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include <cca/base/inlining.hpp>
#include <cca/graph/plan/long_beats.hpp>
#include <cca/runtime/component_call.hpp>

namespace cca::detail {

// The call that has this rank in the order of the beat.
template <class Graph, int Rank>
CCA_INLINE void run_call(const beat_context<Graph>& b) {
  constexpr int call = plan_of<Graph>.order[Rank];
  call_simplified<component_call<Graph, layout_of<Graph>.twin[call]>::run>(b, layout_of<Graph>.calls[call]);
}

// Marked unlikely: otherwise g++ treats the code after several checks as cold and optimises it for size.
CCA_INLINE bool goes_on(const beat_outcome& outcome) {
  if (outcome.fault) [[unlikely]]
    return false;
  return true;
}

// The calls from rank `First` on, until one faults. Where a beat can end early they are one chain of
// conditions, so that g++ sees that no later call reads what an earlier one did not write.
template <class Graph, int First, int... Rank>
CCA_INLINE void run_calls(const beat_context<Graph>& b, std::integer_sequence<int, Rank...>) {
  if constexpr (counts_of<Graph>.may_fault)
    (void)((run_call<Graph, First + Rank>(b), goes_on(b.outcome)) && ...);
  else (run_call<Graph, First + Rank>(b), ...);
}

// Each array of samples is a variable of its own: in one struct a loop over one of them would keep all of
// them in memory, on g++.
template <class Graph, int First, int Count, int... BeatArray>
CCA_INLINE void run_with(controller_state<Graph>& state,
                         beat_outcome& outcome,
                         std::int64_t k,
                         stored_array<Graph, BeatArray>... samples) {
  run_calls<Graph, First>(beat_context<Graph>(state, outcome, k, samples...),
                          std::make_integer_sequence<int, Count>{});
}
template <class Graph, int First, int Count, int... BeatArray>
CCA_INLINE void run_part(controller_state<Graph>& state,
                         beat_outcome& outcome,
                         std::int64_t k,
                         std::integer_sequence<int, BeatArray...>) {
  run_with<Graph, First, Count, BeatArray...>(state, outcome, k, stored_array<Graph, BeatArray>()...);
}

// A part of a long beat: a function of its own.
template <class Graph, int First>
[[gnu::noinline, gnu::flatten]] void run_part_apart(controller_state<Graph>& state,
                                                    beat_outcome& outcome,
                                                    std::int64_t k) noexcept {
  run_part<Graph, First, std::min(calls_in_part<Graph>, counts_of<Graph>.call_count - First)>(
      state, outcome, k, beat_arrays<Graph>{});
}

template <class Graph, int... Part>
CCA_INLINE void run_parts(controller_state<Graph>& state,
                          beat_outcome& outcome,
                          std::int64_t k,
                          std::integer_sequence<int, Part...>) {
  (void)((run_part_apart<Graph, Part * calls_in_part<Graph>>(state, outcome, k), goes_on(outcome)) && ...);
}

template <class Graph>
CCA_INLINE void run_beat(controller_state<Graph>& state, beat_outcome& outcome, std::int64_t k) {
  constexpr int calls = counts_of<Graph>.call_count, most = calls_in_part<Graph>;
  if constexpr (calls <= most) run_part<Graph, 0, calls>(state, outcome, k, beat_arrays<Graph>{});
  else run_parts(state, outcome, k, std::make_integer_sequence<int, (calls + most - 1) / most>{});
}

}  // namespace cca::detail
