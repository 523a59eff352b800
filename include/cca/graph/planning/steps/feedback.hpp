// Step 7, find feedback: which delayed inputs close a loop. Their writer gets data, over any wires, from
// their reader. The origin of such an input does not count for what its component publishes (otherwise the
// age of the data in a loop would grow forever).
#pragma once

#include <cca/graph/plan/flat.hpp>
#include <cca/graph/plan/scratch.hpp>

namespace cca::detail {

// Strongly connected components over all wires, delayed ones too (Tarjan 1972, without recursion).
struct loop_search {
  const flat_view& g;
  scratch group, low, number, stack, frame_node, frame_edge, edge_head, edge_next, edge_to;
  int counter = 0, depth = 0, edges = 0;

  constexpr explicit loop_search(const flat_view& graph)
      : g(graph),
        group(g.node_count, -1),
        low(g.node_count),
        number(g.node_count, -1),
        stack(g.node_count),
        frame_node(g.node_count),
        frame_edge(g.node_count),
        edge_head(g.node_count, -1),
        edge_next(g.input_count),
        edge_to(g.input_count) {
    for (int i = 0; i < g.input_count; ++i)
      if (g.inputs[i].writer >= 0) add_edge(g.outputs[g.inputs[i].writer].call, g.inputs[i].call);
    for (int v = 0; v < g.node_count; ++v)
      if (number[v] < 0) visit(v);
  }

  // Does the writer of this output get data, over any wires, from this reader?
  constexpr bool closes(int reader_call, int output) const {
    return group[g.calls[reader_call].node] == group[g.calls[g.outputs[output].call].node];
  }

  constexpr void add_edge(int from_call, int to_call) {
    const int from = g.calls[from_call].node;
    edge_to[edges] = g.calls[to_call].node;
    edge_next[edges] = edge_head[from];
    edge_head[from] = edges++;
  }

  constexpr void visit(int root) {
    int frames = 0;
    const auto enter = [&](int v) {
      number[v] = low[v] = counter++;
      stack[depth++] = v;
      frame_node[frames] = v;
      frame_edge[frames++] = edge_head[v];
    };
    enter(root);
    while (frames > 0) {
      const int v = frame_node[frames - 1];
      const int e = frame_edge[frames - 1];
      if (e >= 0) {
        frame_edge[frames - 1] = edge_next[e];
        const int w = edge_to[e];
        if (number[w] < 0) enter(w);
        else if (group[w] < 0 && number[w] < low[v]) low[v] = number[w];
        continue;
      }
      if (low[v] == number[v]) {
        int w = -1;
        do {
          w = stack[--depth];
          group[w] = v;
        } while (w != v);
      }
      if (--frames > 0 && low[v] < low[frame_node[frames - 1]]) low[frame_node[frames - 1]] = low[v];
    }
  }
};

constexpr bool has_delays(const flat_view& g) {
  for (int i = 0; i < g.input_count; ++i)
    if (g.inputs[i].delay > 0) return true;
  return false;
}

// An observer of a queue hears what comes by all ways into it. Some may close a loop for it and others not:
// then each sample is marked, because they need not be those that close one for the queue's own component.
constexpr void find_feedback_of_observer(flat_view& g, const loop_search& loops, int observer) {
  auto& in = g.inputs[observer];
  auto& whole = g.inputs[in.shows];
  const auto counts = [&](const input& way) { return way.delay == 0 || !loops.closes(in.call, way.writer); };
  bool some = false, all = true;
  for (int w = in.shows; w >= 0; w = g.inputs[w].next_way) {
    const bool one = counts(g.inputs[w]);
    some |= one;
    all &= one;
  }
  in.counts = some;
  if (some == all) return;
  constexpr int most_marks = 63;  // those after them count what some of them count
  in.counts_vary = whole.counts_vary = true;
  if (whole.mark_count < most_marks) ++whole.mark_count;
  in.mark = whole.mark_count;
  for (int w = in.shows; w >= 0; w = g.inputs[w].next_way)
    if (auto& way = g.inputs[w]; counts(way)) way.counts_for |= std::uint64_t{1} << in.mark;
}

// The step.
constexpr flat_view find_feedback(flat_view g) {
  if (!has_delays(g)) return g;
  const loop_search loops(g);
  for (int i = 0; i < g.input_count; ++i) {
    auto& in = g.inputs[i];
    if (in.delay > 0) in.counts = !loops.closes(in.call, in.writer);
    if (in.way_of >= 0) {
      auto& whole = g.inputs[in.way_of];
      whole.counts_vary |= in.counts != whole.counts;
    }
  }
  for (int i = 0; i < g.input_count; ++i)
    if (g.inputs[i].shows >= 0) find_feedback_of_observer(g, loops, i);
  return g;
}

}  // namespace cca::detail
