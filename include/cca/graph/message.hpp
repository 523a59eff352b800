// What a refused graph is told: the rule's id, what is wrong and where, with both ends, why, and what to do.
#pragma once

#include <cca/graph/message_clocks.hpp>
#include <cca/graph/message_components.hpp>
#include <cca/graph/message_wires.hpp>

namespace cca::detail {

constexpr void tell(telling& t) {
  const auto broken = t.found().broken;
  if (broken == rule::none) return;
  t.say() << rule_ids[static_cast<std::size_t>(broken)] << ": ";
  switch (broken) {
    case rule::node_duplicate_name: return tell_duplicate_name(t);
    case rule::component_no_process: return tell_no_process(t);
    case rule::component_bad_parameter: return tell_bad_signature(t, true);
    case rule::component_bad_result: return tell_bad_signature(t, false);
    case rule::component_hook_signature: return tell_hook(t);
    case rule::parameters_unsupported_type: return tell_parameters(t);
    case rule::space_duplicate_axis: return tell_duplicate_axis(t);
    case rule::strategy_unknown_port: return tell_unknown_trigger(t);
    case rule::strategy_misplaced: return tell_misplaced(t);
    case rule::wire_unknown_port: return tell_unknown_port(t);
    case rule::wire_direction: return tell_direction(t);
    case rule::wire_two_writers: return tell_two_writers(t);
    case rule::wire_bad_initial: return tell_bad_initial(t);
    case rule::space_mismatch: return tell_mismatch(t);
    case rule::wire_unconnected_input: return tell_unconnected(t);
    case rule::rate_missing: return tell_rate_missing(t);
    case rule::strategy_never_fires: return tell_never_fires(t);
    case rule::graph_algebraic_loop: return tell_loop(t);
    case rule::rate_mismatch: return tell_rate_mismatch(t);
    case rule::rate_unstated: return tell_rate_unstated(t);
    case rule::queue_overflow: return tell_overflow(t);
    case rule::strategy_coordination: return tell_coordination(t);
    case rule::space_missing_limits: return tell_missing_limits(t);
    case rule::robot_unlimited_command: return tell_unlimited(t);
    case rule::latency_exceeded: return tell_latency(t);
    case rule::none:
    case rule::count: break;
  }
}

}  // namespace cca::detail
