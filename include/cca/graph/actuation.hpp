// Commands on their way to actuators: each passes a limiter, and each axis has limits.
#pragma once

#include <cca/graph/flat.hpp>

namespace cca::detail {

struct actuation {
  flat_view g;

  constexpr void refuse(rule broken, const item_info* item, int scope, int a = -1, int b = -1) {
    if (g.found.broken == rule::none) g.found = {broken, a, b, -1, item, scope};
  }

  // Every way by which a sample of this output came to be leads through a limiter, or through parts that keep within
  // what they are given (a splitter, a resource node that is checked itself).
  constexpr bool is_limited(int output_index, int depth = 0) const {
    const auto& t = g.turns[g.outputs[output_index].turn];
    const auto& component = *node_of(g, t).component;
    if (component.limits_commands || t.phase == phase_of_beat::act) return true;
    if (!component.preserves_limits || depth > g.leaf_count) return false;
    for (int i = t.first_input; i < t.first_input + t.half->input_count; ++i)
      if (g.inputs[i].writer >= 0 && !is_limited(g.inputs[i].writer, depth + 1)) return false;
    return true;
  }

  constexpr void run() {
    for (int i = 0; i < g.input_count; ++i) {
      const auto& in = g.inputs[i];
      const auto& t = g.turns[in.turn];
      const auto& item = node_of(g, t);
      const auto space = port_of(g, in).space;
      const int scope = g.leaves[t.leaf].scope;
      if (!space) continue;
      const bool actuates = t.phase == phase_of_beat::act && space->actuated;
      if ((actuates || item.component->limits_commands) && space->missing_limits >= 0)
        refuse(rule::space_missing_limits, &item, scope, i);
      if (actuates && in.writer >= 0 && !is_limited(in.writer)) refuse(rule::robot_unlimited_command, in.wire, scope, in.writer, i);
    }
  }
};

}  // namespace cca::detail
