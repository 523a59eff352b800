// What has been under way to queues arrives when a beat begins: the samples of wires that are both delayed
// and queued or merged. Of all that have arrived the one that arrived first enters its queue first; of one
// beat, that which was published first.
//
// Cost: nothing in a graph without such wires; else a test for each of them in each beat.
#pragma once

#include <cca/graph/recordable.hpp>
#include <cca/runtime/state.hpp>

namespace cca::detail {

// A sample comes to the queue of an input by one of the ways into it.
template <class Graph, int Way, class State, class Vector>
CCA_INLINE void put_into_queue(
    State& state, beat_outcome& outcome, const Vector& v, std::int64_t origin, std::int64_t k) {
  constexpr place at = layout_of<Graph>.sources[Way];
  constexpr const auto& in = input_of<Graph, Way>;
  const bool had_room = sample_in<Graph, at.array>(state, at.index).put(v, origin, k, in.counts);
  if constexpr (in.wire->full == full_kind::reject) {
    if (!had_room) outcome = {"a sample arrived while the queue was full", call_of<Graph, in.call>.node};
  }
}

// The end of a delayed way into a queue: `next(k)` is the sample that is the next to enter, if it has arrived
// when beat k begins, else null. A way from another environment has its own (environments/links.hpp).
template <class Graph, int Way, class State>
struct end_of_way {
  static constexpr place at = layout_of<Graph>.on_the_way[Way];
  State& state;

  CCA_INLINE end_of_way(State& s, std::int64_t) : state(s) {}
  CCA_INLINE auto next(std::int64_t k) const { return sample_in<Graph, at.array>(state, at.index).next(k); }
  CCA_INLINE void enter(beat_outcome& outcome, std::int64_t k) const {
    const auto& sample = *next(k);
    put_into_queue<Graph, Way>(state, outcome, sample.vector(), sample.origin(), k);
    sample_in<Graph, at.array>(state, at.index).remove();
  }
};

// In the order in which they enter: by the beats of arrival, then of publication, then by their turns.
struct next_entry {
  std::int64_t arrives_in = 0, published_in = 0;
  int turn = -1;  // -1: there is none

  CCA_INLINE bool is_before(const next_entry& other) const {
    if (arrives_in != other.arrives_in) return arrives_in < other.arrives_in;
    if (published_in != other.published_in) return published_in < other.published_in;
    return turn < other.turn;
  }
};

// The delayed ways into the queue of one input.
template <class Graph, class State, class Ways>
struct entries_of_queue;
template <class Graph, class State, int... Way>
struct entries_of_queue<Graph, State, std::integer_sequence<int, Way...>> : end_of_way<Graph, Way, State>... {
  CCA_INLINE entries_of_queue(State& s, std::int64_t k) : end_of_way<Graph, Way, State>(s, k)... {}

  CCA_INLINE void enter(beat_outcome& outcome, std::int64_t k) {
    if constexpr (sizeof...(Way) == 1) {
      while ((end<Way>().next(k) && ...)) (end<Way>().enter(outcome, k), ...);
    } else {
      for (next_entry first; first = {}, (find<Way>(first, k), ...), first.turn >= 0;)
        (void)((input_of<Graph, Way>.turn == first.turn && (end<Way>().enter(outcome, k), true)) || ...);
    }
  }

private:
  template <int One>
  CCA_INLINE auto& end() {
    return static_cast<end_of_way<Graph, One, State>&>(*this);
  }
  template <int One>
  CCA_INLINE void find(next_entry& first, std::int64_t k) {
    const auto* const sample = end<One>().next(k);
    if (!sample) return;
    const next_entry one{sample->published_in + input_of<Graph, One>.delay, sample->published_in,
                         input_of<Graph, One>.turn};
    if (first.turn < 0 || one.is_before(first)) first = one;
  }
};

template <class Graph, int Input>
struct leads_into {
  static constexpr bool holds(std::size_t i) {
    const auto& in = plan_of<Graph>.inputs[i];
    return is_on_the_way(in) && (in.way_of >= 0 ? in.way_of : static_cast<int>(i)) == Input;
  }
};
template <class Graph>
struct has_late_entries {
  static constexpr bool holds(std::size_t i) {
    const auto& plan = plan_of<Graph>;
    const auto& in = plan.inputs[i];
    if (!is_queued(in) || in.way_of >= 0 || plan.calls[array_size(in.call)].elsewhere) return false;
    for (int way = static_cast<int>(i); way >= 0; way = plan.inputs[array_size(way)].next_way)
      if (plan.inputs[array_size(way)].delay > 0) return true;
    return false;
  }
};
template <class Graph>
using late_queues =
    chosen<counts_of<Graph>.queue_count == 0 ? 0 : counts_of<Graph>.input_count, has_late_entries<Graph>>;

// Can a sample that arrives when a beat begins find a full queue that rejects it?
template <class Graph>
inline constexpr bool rejects_entries = [] {
  for (const input& in : plan_of<Graph>.inputs)
    if (is_on_the_way(in) && in.wire->full == full_kind::reject &&
        !plan_of<Graph>.calls[array_size(in.call)].elsewhere)
      return true;
  return false;
}();

template <class Graph, int Input, class State>
CCA_INLINE void enter_queue(State& state, beat_outcome& outcome, int& rejected_by, std::int64_t k) {
  beat_outcome own;
  entries_of_queue<Graph, State, chosen<counts_of<Graph>.input_count, leads_into<Graph, Input>>>(state, k)
      .enter(own, k);
  if constexpr (rejects_entries<Graph>)
    if (own.fault && !outcome.fault) {
      outcome = own;
      rejected_by = Input;
    }
}

// When beat k begins. All that has arrived enters. The first queue that was full and rejects it is the
// outcome; returned: the number of its input.
template <class Graph, class State>
CCA_INLINE int enter_queues([[maybe_unused]] State& state,
                            [[maybe_unused]] beat_outcome& outcome,
                            [[maybe_unused]] std::int64_t k) {
  int rejected_by = -1;
  [&]<int... Input>(std::integer_sequence<int, Input...>) {
    (enter_queue<Graph, Input>(state, outcome, rejected_by, k), ...);
  }(late_queues<Graph>{});
  return rejected_by;
}

// The same graph without a recorder.
template <class Graph>
struct as_planned {
  using type = Graph;
};
template <class Graph>
struct as_planned<probed<Graph>> {
  using type = Graph;
};

}  // namespace cca::detail
