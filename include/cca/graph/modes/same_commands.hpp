// Do two modes give an actuator its commands in the same way? A limiter that both have goes on from its last
// command, so what comes after it does not jump.
#pragma once

#include <cca/graph/plan/commands.hpp>
#include <cca/graph/plan/names.hpp>

namespace cca::detail {

// A mode, and the shared nodes by path.
struct mode_view {
  const flat_view& g;      // of the mode
  const flat_view& whole;  // all modes together
  const table_entry* names;
  std::uint64_t mask;

  constexpr int shared_node(int node) const {
    const auto& n = g.nodes[node];
    return find(names, mask, path_hash(g.scopes[n.scope], n.item->from, n.item->from_hash));
  }
  constexpr int shared_call(int call) const {
    const int node = g.calls[call].node;
    return whole.nodes[shared_node(node)].first_call + call - g.nodes[node].first_call;
  }
  constexpr int shared_output(int output) const {
    if (output < 0) return -1;
    const auto& o = g.outputs[output];
    if (o.is_taken) return shared_taken(shared_call(o.call), o.port);
    return whole.calls[shared_call(o.call)].first_output + output - g.calls[o.call].first_output;
  }
  // What is taken from the queue of an input; the number of the next output, if no mode has that yet.
  constexpr int shared_taken(int call, int port) const {
    int o = whole.output_count - whole.taken_count;
    while (o < whole.output_count && !(whole.outputs[o].call == call && whole.outputs[o].port == port)) ++o;
    return o;
  }
};

// Where two ways to an actuator part: the inputs, of which both modes have one; -1: nowhere.
struct parting {
  int input = -1, other = -1;
};

constexpr bool carries_alike(const input& a, const input& b) {
  return a.delay == b.delay && (a.queue >= 0) == (b.queue >= 0) &&
         (a.queue < 0 || (a.wire->capacity == b.wire->capacity && a.wire->full == b.wire->full));
}

constexpr parting find_parting(
    const mode_view& one, int input, const mode_view& other, int other_input, int depth = 0) {
  const auto &a = one.g.inputs[input], &b = other.g.inputs[other_input];
  if (one.shared_output(a.writer) != other.shared_output(b.writer)) return {input, other_input};
  if (a.writer < 0 || depth > one.g.node_count) return {};
  if (!carries_alike(a, b)) return {input, other_input};
  if (a.next_way >= 0 || b.next_way >= 0) {
    if (a.next_way < 0 || b.next_way < 0) return {input, other_input};
    if (const auto found = find_parting(one, a.next_way, other, b.next_way, depth); found.input >= 0)
      return found;
  }
  const auto& from = one.g.calls[one.g.outputs[a.writer].call];
  const auto& from_other = other.g.calls[other.g.outputs[b.writer].call];
  if (ends_limit_search(one.g, from)) return {};
  for (int p = 0; p < from.function->input_count; ++p)
    if (const auto found =
            find_parting(one, from.first_input + p, other, from_other.first_input + p, depth + 1);
        found.input >= 0)
      return found;
  return {};
}

}  // namespace cca::detail
