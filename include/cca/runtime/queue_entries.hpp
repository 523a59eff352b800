// What has been under way to queues arrives when a beat begins: the samples of wires that are both delayed
// and queued or merged. Of all that have arrived the one that arrived first enters its queue first; of one
// beat, that which was published first.
//
// What comes without a delay from another environment, of which one is free-running, enters before the first
// call that must find it there (environments/queues); what is left of earlier beats, when a beat begins.
//
// Cost: nothing in a graph without such wires; else a test for each of them in each beat.
#pragma once

#include <cca/graph/marks/recordable.hpp>
#include <cca/runtime/state.hpp>

namespace cca::detail {

// The same graph without a recorder.
template <class Graph>
struct as_planned {
  using type = Graph;
};
template <class Graph>
struct as_planned<probed<Graph>> {
  using type = Graph;
};

// Of a replay: the component of a call does not run, but publishes what was recorded (record/replay.hpp).
// Its inputs keep no samples waiting.
template <class Graph, int Call>
struct played_call {
  static constexpr bool is_now(const auto&) { return false; }
};

// A sample comes to the queue of an input by one of the ways into it.
template <class Graph, int Way, class State, class Vector>
CCA_INLINE void put_into_queue(
    State& state, beat_outcome& outcome, const Vector& v, std::int64_t origin, std::int64_t k) {
  constexpr place at = layout_of<Graph>.sources[Way];
  constexpr const auto& in = input_of<Graph, Way>;
  const bool had_room =
      sample_in<Graph, at.array>(state, at.index).put(v, origin, k, in.counts_for | std::uint64_t{in.counts});
  if constexpr (in.wire->full == full_kind::reject) {
    if (!had_room && !played_call<typename as_planned<Graph>::type, in.call>::is_now(state))
      outcome = {"a sample arrived while the queue was full", call_of<Graph, in.call>.node};
  }
}
// Samples that should have come before the next one are missing.
template <class Graph, int Way, class State>
void lose_before_queue(State& state, std::int64_t samples) {
  constexpr place at = layout_of<Graph>.sources[Way];
  sample_in<Graph, at.array>(state, at.index).lose(samples);
}

// The end of a way into a queue by which samples enter later than they are published: `next(k)` is the sample
// that is the next to enter, if it has arrived when beat k begins, else null. A way from another environment
// has its own (environments/queues): by one without delay it may also enter in the beat.
template <class Graph, int Way, class State>
struct end_of_way {
  static constexpr place at = layout_of<Graph>.on_the_way[Way];
  State& state;

  CCA_INLINE end_of_way(State& s, std::int64_t, bool) : state(s) {}
  CCA_INLINE auto next(std::int64_t k) const { return sample_in<Graph, at.array>(state, at.index).next(k); }
  CCA_INLINE void enter(beat_outcome& outcome, std::int64_t k) const {
    const auto& sample = *next(k);
    if constexpr (output_of<Graph, input_of<Graph, Way>.writer>.in_a_beat > 1)
      lose_before_queue<Graph, Way>(state, sample.missing);
    put_into_queue<Graph, Way>(state, outcome, sample.vector(), sample.origin(), k);
    sample_in<Graph, at.array>(state, at.index).remove();
  }
};

// In the order in which they enter: by the beats of arrival, then of publication, then by their turns. What
// is not delayed is published last.
struct next_entry {
  std::int64_t arrives_in = 0, published_in = 0;
  int turn = -1;  // -1: there is none

  CCA_INLINE bool is_before(const next_entry& other) const {
    if (arrives_in != other.arrives_in) return arrives_in < other.arrives_in;
    if (published_in != other.published_in) return published_in < other.published_in;
    return turn < other.turn;
  }
};

// Such ways into the queue of one input. `in_beat`: by those without delay also what is published in beat k.
template <class Graph, class State, class Ways>
struct entries_of_queue;
template <class Graph, class State, int... Way>
struct entries_of_queue<Graph, State, std::integer_sequence<int, Way...>> : end_of_way<Graph, Way, State>... {
  CCA_INLINE entries_of_queue(State& s, std::int64_t k, bool in_beat = false)
      : end_of_way<Graph, Way, State>(s, k, in_beat)... {}

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
    const auto* const next = end<One>().next(k);
    if (!next) return;
    const next_entry one{next->published_in + input_of<Graph, One>.delay, next->published_in,
                         input_of<Graph, One>.turn};
    if (first.turn < 0 || one.is_before(first)) first = one;
  }
};

constexpr bool enters_later(const auto& plan, const input& way) {
  return is_on_the_way(way) ||
         (is_queued(way) && plan.calls[array_size(plan.outputs[array_size(way.writer)].call)].elsewhere);
}
template <class Graph, int Input>
struct leads_into {
  static constexpr bool holds(std::size_t i) {
    const auto& in = plan_of<Graph>.inputs[i];
    return enters_later(plan_of<Graph>, in) && (in.way_of >= 0 ? in.way_of : static_cast<int>(i)) == Input;
  }
};
template <class Graph>
struct has_late_entries {
  static constexpr bool holds(std::size_t i) {
    const auto& plan = plan_of<Graph>;
    const auto& in = plan.inputs[i];
    if (!is_queued(in) || in.way_of >= 0 || plan.calls[array_size(in.call)].elsewhere) return false;
    for (int way = static_cast<int>(i); way >= 0; way = plan.inputs[array_size(way)].next_way)
      if (enters_later(plan, plan.inputs[array_size(way)])) return true;
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
    if (enters_later(plan_of<Graph>, in) && in.wire->full == full_kind::reject &&
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

}  // namespace cca::detail
