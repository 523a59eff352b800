// Last step: what outlives a beat. A sample that no later beat reads stays a local of the loop; delayed
// readers need some past; an input whose delayed wire closes a loop does not count for the time of origin.
#pragma once

#include <cca/graph/plan/flat.hpp>
#include <cca/graph/plan/scratch.hpp>
#include <cca/graph/parts.hpp>

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
        edge_next(g.input_count + g.link_count),
        edge_to(g.input_count + g.link_count) {
    for (int i = 0; i < g.input_count; ++i)
      if (g.inputs[i].writer >= 0) add_edge(g.outputs[g.inputs[i].writer].call, g.inputs[i].call);
    for (int l = 0; l < g.link_count; ++l)
      add_edge(g.outputs[g.links[l].output].call, g.inputs[g.links[l].input].call);
    for (int v = 0; v < g.node_count; ++v)
      if (number[v] < 0) visit(v);
  }

  // Is the writer of this output fed, over any wires, by the one who reads it?
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

struct remembering {
  flat_view g;

  constexpr int delay_of_link(const link& l) const { return port_of(g, g.inputs[l.input]).observed_delay; }

  constexpr bool has_delays() const {
    for (int i = 0; i < g.input_count; ++i)
      if (g.inputs[i].delay > 0) return true;
    for (int l = 0; l < g.link_count; ++l)
      if (delay_of_link(g.links[l]) > 0) return true;
    return false;
  }

  constexpr void find_loops() {
    if (!has_delays()) return;
    const loop_search loops(g);
    for (int i = 0; i < g.input_count; ++i) {
      auto& in = g.inputs[i];
      if (in.delay > 0) in.counts = !loops.closes(in.call, in.writer);
    }
    for (int l = 0; l < g.link_count; ++l) {
      auto& link = g.links[l];
      if (delay_of_link(link) > 0) link.counts = !loops.closes(g.inputs[link.input].call, link.output);
    }
  }

  // It fires only when this input has just arrived: the only one, and no sample waits.
  constexpr bool fires_with(const input& i) const {
    const auto& t = g.calls[i.call];
    if (!strategy_of_call(g, t).fires_on_arrival) return false;
    int wired = 0;
    for (int other = t.first_input; other < t.first_input + t.function->input_count; ++other)
      wired += g.inputs[other].wired;
    return wired == 1;
  }

  // Of the readers of a local sample, the last in the order of the beat.
  constexpr void find_last(const output& out) {
    int last = -1;
    for (int i = out.first_reader; i >= 0; i = g.inputs[i].next_of_writer)
      if (!is_queued(g.inputs[i]) && g.inputs[i].delay == 0 &&
          (last < 0 || g.calls[g.inputs[i].call].rank > g.calls[g.inputs[last].call].rank))
        last = i;
    if (last >= 0) g.inputs[last].is_last = true;
  }

  // Samples that a reader with a delay may still need: it may come before or after the writer in a beat.
  constexpr int past(int delay, int reader_call, int writer_call) const {
    return g.calls[reader_call].rank < g.calls[writer_call].rank ? delay : delay + 1;
  }

  static constexpr bool same_initial(ref<item_info> a, ref<item_info> b, int size) {
    for (int c = 0; c < size; ++c) {
      const auto value = [c](ref<item_info> w) {
        return w && w->initial ? w->initial[w->initial_count == 1 ? 0 : c] : 0.0;
      };
      if (bool(a && a->initial) != bool(b && b->initial) || value(a) != value(b)) return false;
    }
    return true;
  }

  constexpr void place(int o) {
    auto& out = g.outputs[o];
    const auto c = published(g, out);
    int deepest = 0;
    out.kept = out.watched;
    for (int i = out.first_reader; i >= 0; i = g.inputs[i].next_of_writer) {
      auto& in = g.inputs[i];
      const int delay = in.delay;
      if (delay > 0) {
        const int need = past(delay, in.call, out.call);
        deepest = need > deepest ? need : deepest;
      } else if (in.queue < 0) {
        in.in_beat = contains(c, g.calls[in.call].fires) || fires_with(in);
        if (!in.in_beat || !in_one_part(g, in.call, out.call)) out.kept = true;
      }
    }
    for (int l = 0; l < g.link_count; ++l)
      if (g.links[l].output == o) {
        out.kept = true;
        const int delay = delay_of_link(g.links[l]);
        if (delay > 0) {
          const int need = past(delay, g.inputs[g.links[l].input].call, out.call);
          deepest = need > deepest ? need : deepest;
        }
      }
    if (deepest == 1) out.kept = true;
    if (deepest > 1) {
      out.ring = 1;
      while (out.ring < deepest) out.ring *= 2;
    }
    out.stamped = c.dynamic() && (out.kept || out.ring > 0);
    bool first = true;
    for (int i = out.first_reader; i >= 0; i = g.inputs[i].next_of_writer) {
      auto& in = g.inputs[i];
      if (in.queue >= 0) continue;
      const bool delayed = in.delay > 0;
      in.is_kept = out.kept && !(delayed && out.ring > 0);
      if (!delayed && !out.kept) out.local = true;
      if (!in.is_kept || in.in_beat) continue;
      if (first) out.initial_of = in.wire;
      first = false;
      in.own_initial = !same_initial(out.initial_of, in.wire, port_of(g, in).space->size);
    }
    if (g.ends_locals && out.local && c.every_beat()) find_last(out);
  }

  constexpr void run() {
    find_loops();
    for (int t = 0; t < g.call_count; ++t)
      g.calls[t].stored_seen = uses_coordination(strategy_of_call(g, g.calls[t]));
    for (int o = 0; o < g.output_count; ++o) place(o);
  }
};

}  // namespace cca::detail
