// Step 5, order the calls of a beat: all senses, then all components, then all acts; within each the
// topological order over wires without delay: again and again the first declared call whose predecessors are
// all placed.
#pragma once

#include <cca/graph/diagnosis/rules/check.hpp>
#include <cca/graph/plan/scratch.hpp>

namespace cca::detail {

// Calls f(reader's call) for each wire without delay that leaves a call. An observer of what waits in a queue
// comes after all that is brought there.
template <class F>
constexpr void for_each_follower(const flat_view& g, int call_index, F f) {
  const auto& t = g.calls[call_index];
  for (int o = t.first_output; o < t.first_output + t.function->output_count; ++o)
    for (int i = g.outputs[o].first_reader; i >= 0; i = g.inputs[i].next_of_writer)
      if (const auto& in = g.inputs[i]; in.delay == 0 && !in.outside) {
        f(in.call);
        for (int h = g.first_link; in.queue >= 0 && h < g.input_count; ++h)
          if (g.inputs[h].shows == (in.way_of >= 0 ? in.way_of : i)) f(g.inputs[h].call);
      }
}

// A heap with the lowest number on top.
struct ready_calls {
  scratch heap;
  int size = 0;

  constexpr void push(int call_index) {
    int at = size++;
    while (at > 0 && heap[(at - 1) / 2] > call_index) {
      heap[at] = heap[(at - 1) / 2];
      at = (at - 1) / 2;
    }
    heap[at] = call_index;
  }
  constexpr int pop() {
    const int top = heap[0], last = heap[--size];
    int at = 0;
    for (int child = 1; child < size; child = 2 * at + 1) {
      if (child + 1 < size && heap[child + 1] < heap[child]) ++child;
      if (heap[child] >= last) break;
      heap[at] = heap[child];
      at = child;
    }
    heap[at] = last;
    return top;
  }
};

struct call_sorter {
  flat_view g;

  constexpr bool in_declared_order() const {
    for (int i = 0; i < g.input_count; ++i) {
      const auto& to = g.inputs[i];
      if (to.shows >= 0) return false;
      if (to.writer < 0 || to.delay > 0 || to.outside) continue;
      const auto& from = g.outputs[to.writer];
      if (g.calls[from.call].phase == g.calls[to.call].phase
              ? from.call >= to.call
              : g.calls[from.call].phase > g.calls[to.call].phase)
        return false;
    }
    return true;
  }

  constexpr void run() {
    int done = 0;
    const bool declared = in_declared_order();
    scratch pending(g.call_count);
    if (!declared)
      for (int t = 0; t < g.call_count; ++t) for_each_follower(g, t, [&](int to) { ++pending[to]; });
    for (const auto phase : {phase_of_beat::sense, phase_of_beat::process, phase_of_beat::act}) {
      if (declared) {
        for (int t = 0; t < g.call_count; ++t)
          if (g.calls[t].phase == phase) g.order[done++] = t;
        continue;
      }
      ready_calls ready{scratch(g.call_count)};
      for (int t = 0; t < g.call_count; ++t)
        if (g.calls[t].phase == phase && pending[t] == 0) ready.push(t);
      while (ready.size > 0) {
        const int t = ready.pop();
        g.order[done++] = t;
        for_each_follower(g, t, [&](int to) {
          if (--pending[to] == 0 && g.calls[to].phase == phase) ready.push(to);
        });
      }
    }
    g.order_count = done;
    for (int t = 0; t < g.call_count; ++t) g.calls[t].rank = -1;
    for (int i = 0; i < done; ++i) g.calls[g.order[i]].rank = i;
    if (done < g.call_count) check<when::unordered_calls>(g, {});
    for (int i = 0; i < g.input_count; ++i) g.inputs[i].turn = turn_of(g.inputs[i]);
  }

  // How many of the ways into the same input publish before this one in a beat.
  constexpr int turn_of(const input& in) const {
    int before = 0;
    if (is_merged(in))
      for (int i = in.way_of >= 0 ? in.way_of : first_way(in); i >= 0; i = g.inputs[i].next_way)
        before += publishes_before(g.inputs[i], in);
    return before;
  }
  constexpr int first_way(const input& in) const { return static_cast<int>(&in - g.inputs); }
  constexpr bool publishes_before(const input& one, const input& other) const {
    const int rank = g.calls[g.outputs[one.writer].call].rank,
              other_rank = g.calls[g.outputs[other.writer].call].rank;
    if (rank != other_rank) return rank < other_rank;
    return one.writer != other.writer ? one.writer < other.writer : first_way(one) < first_way(other);
  }
};

constexpr flat_view order_calls(flat_view g) {
  call_sorter step{g};
  step.run();
  return step.g;
}

}  // namespace cca::detail
