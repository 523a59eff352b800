// One beat of a graph: every call in its order, with the samples of the beat as local variables.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <cca/base/inlining.hpp>
#include <cca/graph/plan/long_beats.hpp>
#include <cca/runtime/component_call.hpp>

namespace cca::detail {

// Marked unlikely: otherwise the code after several checks is taken for cold and optimised for size
// (docs/compilers.md).
CCA_INLINE bool goes_on(const beat_outcome& outcome) {
  if (outcome.fault) [[unlikely]]
    return false;
  return true;
}

// The same after the call of this rank, and where another environment lets no further call have its turn.
CCA_INLINE bool goes_on_after(beat_outcome& outcome, int rank) {
  if (outcome.fault) [[unlikely]]
    return outcome.turns = rank + 1, false;
  return true;
}
CCA_INLINE bool ends_before(beat_outcome& outcome, int rank) {
  outcome.turns = std::min(outcome.turns, rank);
  return false;
}

// What has been under way arrives. False: a queue was full that must not be, and the beat ends here.
template <class Graph>
CCA_INLINE bool begins(controller_state<Graph>& state, beat_outcome& outcome, std::int64_t k) {
  [[maybe_unused]] const int input = enter_queues<typename as_planned<Graph>::type>(state, outcome, k);
  if constexpr (!rejects_entries<Graph>) return true;
  else if constexpr (requires { state.have_entered(k, outcome, input); })
    return state.have_entered(k, outcome, input);
  else return goes_on(outcome);
}

// The calls from rank `First` on.
template <class Graph, int First, class Ranks, class BeatArrays>
struct calls_of_beat;
template <class Graph, int First, int... Rank, int... BeatArray>
struct calls_of_beat<Graph,
                     First,
                     std::integer_sequence<int, Rank...>,
                     std::integer_sequence<int, BeatArray...>> {
  // Each array of samples is a variable of its own: in one struct a loop over one of them would keep all of
  // them in memory (docs/compilers.md).
  CCA_INLINE static void run(controller_state<Graph>& state,
                             beat_outcome& outcome,
                             std::int64_t k,
                             frame_of_beat<Graph> frame) {
    run_calls({state, outcome, k, frame, derived_rooms<Graph>(), derived_marks<Graph>(),
               stored_array<Graph, BeatArray>()...});
  }

private:
  static constexpr int call_at(int rank) { return plan_of<Graph>.order[static_cast<std::size_t>(rank)]; }

  // Until one faults. Where a beat can end early the calls are one chain of conditions: it shows the compiler
  // that no later call reads what an earlier one did not write. In a deployment, also until a fault
  // elsewhere.
  CCA_INLINE static void run_calls([[maybe_unused]] const beat_context<Graph>& b) {
    if constexpr (requires { b.state.template is_due<0>(b.k, b.outcome, trace_of<Graph>(b.state)); })
      (void)(((b.state.template is_due<First + Rank>(b.k, b.outcome, trace_of<Graph>(b.state)) ||
               ends_before(b.outcome, First + Rank)) &&
              (call_simplified<component_call<Graph, layout_of<Graph>.twin[call_at(First + Rank)]>::run>(
                   b, layout_of<Graph>.calls[call_at(First + Rank)]),
               goes_on_after(b.outcome, First + Rank) ? b.state.template is_done<First + Rank>(b.k)
                                                      : b.state.template is_faulted<First + Rank>())) &&
             ...);
    else if constexpr (counts_of<Graph>.may_fault)
      (void)((call_simplified<component_call<Graph, layout_of<Graph>.twin[call_at(First + Rank)]>::run>(
                  b, layout_of<Graph>.calls[call_at(First + Rank)]),
              goes_on_after(b.outcome, First + Rank)) &&
             ...);
    else
      (call_simplified<component_call<Graph, layout_of<Graph>.twin[call_at(First + Rank)]>::run>(
           b, layout_of<Graph>.calls[call_at(First + Rank)]),
       ...);
  }
};

template <class Graph, int First, int Count>
using part_of_beat = calls_of_beat<Graph, First, std::make_integer_sequence<int, Count>, beat_arrays<Graph>>;

// A beat in parts (graph/plan/long_beats.hpp), each a function of its own.
template <class Graph, class Parts>
struct long_beat;
template <class Graph, int... Part>
struct long_beat<Graph, std::integer_sequence<int, Part...>> {
  CCA_INLINE static void run(controller_state<Graph>& state,
                             beat_outcome& outcome,
                             std::int64_t k,
                             frame_of_beat<Graph> frame) {
    (void)((run_part<Part * calls_in_part<Graph>>(state, outcome, k, frame), goes_on(outcome)) && ...);
  }

private:
  template <int First>
  [[gnu::noinline]] CCA_BEAT static void run_part(controller_state<Graph>& state,
                                                  beat_outcome& outcome,
                                                  std::int64_t k,
                                                  frame_of_beat<Graph> frame) noexcept {
    constexpr int left = counts_of<Graph>.order_count - First;
    part_of_beat<Graph, First, std::min(calls_in_part<Graph>, left)>::run(state, outcome, k, frame);
  }
};

template <class Graph>
using beat_of_graph = std::conditional_t<
    (counts_of<Graph>.order_count <= calls_in_part<Graph>),
    part_of_beat<Graph, 0, std::min(counts_of<Graph>.order_count, calls_in_part<Graph>)>,
    long_beat<Graph,
              std::make_integer_sequence<int,
                                         (counts_of<Graph>.order_count + calls_in_part<Graph> - 1) /
                                             calls_in_part<Graph>>>>;

// The same after what has been under way to queues has arrived, in a graph that has such queues.
template <class Graph>
CCA_INLINE void run_beat_of_graph(controller_state<Graph>& state,
                                  beat_outcome& outcome,
                                  std::int64_t k,
                                  frame_of_beat<Graph> frame) {
  if constexpr (late_queues<Graph>::size() == 0) beat_of_graph<Graph>::run(state, outcome, k, frame);
  else if (begins<Graph>(state, outcome, k)) beat_of_graph<Graph>::run(state, outcome, k, frame);
  else outcome.turns = 0;
}

}  // namespace cca::detail
