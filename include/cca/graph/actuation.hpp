// Commands on their way to actuators: each passes a limiter, and each axis has limits.
#pragma once

#include <cca/graph/flat.hpp>

namespace cca::detail {

struct actuation {
  flat_view g;

  constexpr void refuse(rule broken, const item_info* item, int scope, int a = -1, int b = -1, int c = -1) {
    if (g.found.broken == rule::none) g.found = {broken, a, b, c, item, scope};
  }

  // Every way by which a sample of this output came to be leads through a limiter, or through parts that keep
  // within what they are given (a splitter, a resource node that is checked itself).
  constexpr bool is_limited(int output_index, int depth = 0) const {
    const auto& t = g.calls[g.outputs[output_index].call];
    const auto& component = *item_of_call(g, t).component;
    if (component.limits_commands || t.phase == phase_of_beat::act) return true;
    if (!component.preserves_limits || depth > g.node_count) return false;
    for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i)
      if (g.inputs[i].writer >= 0 && !is_limited(g.inputs[i].writer, depth + 1)) return false;
    return true;
  }

  // An initial value that the wire states is a command as well: the axis along which it lies outside of the
  // limits, or -1.
  constexpr int beyond_limits(const input& in) const {
    const auto& wire = *in.wire;
    if (!wire.initial || in.in_beat) return -1;
    const auto& space = *port_of(g, in).space;
    for (int c = 0; c < space.axis_count; ++c) {
      const double value = wire.initial[wire.initial_count == 1 ? 0 : c];
      if (!(space.lower[c] <= value && value <= space.upper[c])) return c;
    }
    return -1;
  }

  // On all wires between an actuator and the limiters that it is fed by, for what it gets before these have
  // fired.
  constexpr void check_initial(int input_index, int actuator, int depth = 0) {
    const auto& in = g.inputs[input_index];
    if (in.writer < 0 || depth > g.node_count) return;
    if (const int c = beyond_limits(in); c >= 0)
      refuse(rule::robot_unlimited_command, in.wire, g.nodes[g.calls[in.call].node].scope, input_index,
             actuator, c);
    const auto& t = g.calls[g.outputs[in.writer].call];
    const auto& component = *item_of_call(g, t).component;
    if (component.limits_commands || t.phase == phase_of_beat::act || !component.preserves_limits) return;
    for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i)
      check_initial(i, actuator, depth + 1);
  }

  constexpr void run() {
    for (int i = 0; i < g.input_count; ++i) {
      const auto& in = g.inputs[i];
      const auto& t = g.calls[in.call];
      const auto& item = item_of_call(g, t);
      const auto space = port_of(g, in).space;
      const int scope = g.nodes[t.node].scope;
      if (!space) continue;
      const bool actuates = t.phase == phase_of_beat::act && space->actuated;
      if ((actuates || item.component->limits_commands) && space->missing_limits >= 0)
        refuse(rule::space_missing_limits, &item, scope, i);
      if (actuates && in.writer >= 0 && !is_limited(in.writer))
        refuse(rule::robot_unlimited_command, in.wire, scope, in.writer, i);
      if (actuates) check_initial(i, i);
    }
  }
};

}  // namespace cca::detail
