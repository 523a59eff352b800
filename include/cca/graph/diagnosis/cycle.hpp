// Finds the cycle of wires without delay because of which a graph has no order.
#pragma once

#include <array>

#include <cca/graph/plan/flat.hpp>
#include <cca/graph/plan/scratch.hpp>

namespace cca::detail {

struct wire_cycle {
  std::array<int, 64> inputs{};  // each is the input of a wire of the cycle, in order
  int length = 0;
  bool backwards = false;  // an act or a component feeds what comes before it in a beat
};

// An input without delay of this function whose writer has no place in the order either.
constexpr int waiting_input(const flat_view& g, int call_index) {
  const auto& t = g.calls[call_index];
  for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i)
    for (int way = i; way >= 0; way = g.inputs[way].next_way)
      if (const auto& in = g.inputs[way];
          in.writer >= 0 && in.delay == 0 && g.calls[g.outputs[in.writer].call].rank < 0)
        return way;
  return -1;
}

constexpr wire_cycle find_cycle(const flat_view& g) {
  wire_cycle found;
  for (int i = 0; i < g.first_link; ++i) {
    const auto& in = g.inputs[i];
    if (in.writer < 0 || in.delay > 0 || g.calls[in.call].rank >= 0) continue;
    if (g.calls[g.outputs[in.writer].call].phase > g.calls[in.call].phase) {
      found.inputs[0] = i;
      found.length = 1;
      found.backwards = true;
      return found;
    }
  }
  int start = -1;
  for (int t = 0; t < g.call_count && start < 0; ++t)
    if (g.calls[t].rank < 0 && waiting_input(g, t) >= 0) start = t;
  if (start < 0) return found;
  // Go back along waiting inputs until a function comes a second time.
  scratch visited(g.call_count);
  int at = start;
  while (at >= 0 && !visited[at]) {
    visited[at] = 1;
    const int i = waiting_input(g, at);
    if (i < 0) return found;
    at = g.outputs[g.inputs[i].writer].call;
  }
  const int first = at;
  do {
    const int i = waiting_input(g, at);
    if (found.length < 64) found.inputs[static_cast<std::size_t>(found.length++)] = i;
    at = g.outputs[g.inputs[i].writer].call;
  } while (at != first);
  for (int i = 0; i < found.length / 2; ++i) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(found.length - 1 - i);
    const int swapped = found.inputs[a];
    found.inputs[a] = found.inputs[b];
    found.inputs[b] = swapped;
  }
  return found;
}

}  // namespace cca::detail
