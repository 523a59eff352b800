// Commands on their way to actuators: each passes a limiter.
#pragma once

#include <cca/graph/plan/flat.hpp>

namespace cca::detail {

// Does an input move something?
constexpr bool is_actuated(const flat_view& g, const input& in) {
  const auto& t = g.calls[in.call];
  const auto& space = port_of(g, in).space;  // none of an observer, which moves nothing
  return t.phase == phase_of_beat::act && !item_of_call(g, t).component->moves_nothing && space &&
         space->actuated;
}

// Commands that leave this function are limited: it is a limiter, or a resource node that is checked itself.
constexpr bool ends_limit_search(const flat_view& g, const call& t) {
  const auto& component = *item_of_call(g, t).component;
  return component.limits_commands || (t.phase == phase_of_beat::act && !component.moves_nothing);
}

// Do all ways to this output lead through a limiter, or through components that keep their outputs within the
// range of their inputs (a splitter)?
constexpr int unlimited_way(const flat_view& g, int input_index, int depth = 0);
constexpr bool is_limited(const flat_view& g, int output_index, int depth = 0) {
  const auto& t = g.calls[g.outputs[output_index].call];
  if (ends_limit_search(g, t)) return true;
  if (!item_of_call(g, t).component->preserves_limits || depth > g.node_count) return false;
  for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i)
    if (unlimited_way(g, i, depth + 1) >= 0) return false;
  return true;
}
constexpr int unlimited_way(const flat_view& g, int input_index, int depth) {
  for (int way = input_index; way >= 0; way = g.inputs[way].next_way)
    if (g.inputs[way].writer >= 0 && !is_limited(g, g.inputs[way].writer, depth)) return way;
  return -1;
}

// The axis along which the initial value that a wire states lies outside of the limits, or -1.
constexpr int axis_beyond_limits(const flat_view& g, const input& in) {
  if (!in.initial || in.in_beat) return -1;
  const auto& wire = *in.initial;
  const auto& space = *port_of(g, in).space;
  for (int c = 0; c < space.axis_count; ++c) {
    const double value = wire.initial[wire.initial_count == 1 ? 0 : c];
    if (!(space.lower[c] <= value && value <= space.upper[c])) return c;
  }
  return -1;
}

struct initial_beyond_limits {
  int input = -1, axis = -1;
};

// On all wires between this input and the limiters before it: what they hold may be read before a limiter
// first fires.
constexpr initial_beyond_limits find_initial_beyond_limits(const flat_view& g,
                                                           int input_index,
                                                           int depth = 0) {
  const auto& in = g.inputs[input_index];
  if (in.writer < 0 || depth > g.node_count) return {};
  if (const int axis = axis_beyond_limits(g, in); axis >= 0) return {input_index, axis};
  initial_beyond_limits found;
  for_each_way(g, input_index, [&](const input& way) {
    const auto& t = g.calls[g.outputs[way.writer].call];
    if (ends_limit_search(g, t) || !item_of_call(g, t).component->preserves_limits) return;
    for (int i = t.first_input; i < t.first_input + t.function->input_count && found.axis < 0; ++i)
      found = find_initial_beyond_limits(g, i, depth + 1);
  });
  return found;
}

}  // namespace cca::detail
