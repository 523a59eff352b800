// All rules of graphs; a wing has a list of its own. Of the rules that an event of a step breaks, the first
// in this list is reported; the pages list them in this order. CONTRIBUTING.md says how to add one.
#pragma once

#include <cca/graph/diagnosis/rules/commands/robot_unlimited_command.hpp>
#include <cca/graph/diagnosis/rules/commands/space_missing_limits.hpp>
#include <cca/graph/diagnosis/rules/components/component_bad_parameter.hpp>
#include <cca/graph/diagnosis/rules/components/component_bad_result.hpp>
#include <cca/graph/diagnosis/rules/components/component_hook_signature.hpp>
#include <cca/graph/diagnosis/rules/components/component_no_process.hpp>
#include <cca/graph/diagnosis/rules/components/graph_unknown_item.hpp>
#include <cca/graph/diagnosis/rules/components/node_bad_name.hpp>
#include <cca/graph/diagnosis/rules/components/node_duplicate_name.hpp>
#include <cca/graph/diagnosis/rules/components/parameters_unsupported_type.hpp>
#include <cca/graph/diagnosis/rules/components/part_unknown_path.hpp>
#include <cca/graph/diagnosis/rules/components/skeleton_arity.hpp>
#include <cca/graph/diagnosis/rules/components/space_duplicate_axis.hpp>
#include <cca/graph/diagnosis/rules/observers/observe_bad_policy.hpp>
#include <cca/graph/diagnosis/rules/observers/observe_nothing.hpp>
#include <cca/graph/diagnosis/rules/observers/plan_unknown_path.hpp>
#include <cca/graph/diagnosis/rules/strategies/strategy_coordination.hpp>
#include <cca/graph/diagnosis/rules/strategies/strategy_misplaced.hpp>
#include <cca/graph/diagnosis/rules/strategies/strategy_never_fires.hpp>
#include <cca/graph/diagnosis/rules/strategies/strategy_no_fires.hpp>
#include <cca/graph/diagnosis/rules/strategies/strategy_not_stoppable.hpp>
#include <cca/graph/diagnosis/rules/strategies/strategy_unknown_port.hpp>
#include <cca/graph/diagnosis/rules/time/graph_algebraic_loop.hpp>
#include <cca/graph/diagnosis/rules/time/latency_exceeded.hpp>
#include <cca/graph/diagnosis/rules/time/queue_overflow.hpp>
#include <cca/graph/diagnosis/rules/time/rate_mismatch.hpp>
#include <cca/graph/diagnosis/rules/time/rate_missing.hpp>
#include <cca/graph/diagnosis/rules/time/rate_unstated.hpp>
#include <cca/graph/diagnosis/rules/wires/learner_request.hpp>
#include <cca/graph/diagnosis/rules/wires/space_mismatch.hpp>
#include <cca/graph/diagnosis/rules/wires/wire_bad_initial.hpp>
#include <cca/graph/diagnosis/rules/wires/wire_bad_option.hpp>
#include <cca/graph/diagnosis/rules/wires/wire_direction.hpp>
#include <cca/graph/diagnosis/rules/wires/wire_two_writers.hpp>
#include <cca/graph/diagnosis/rules/wires/wire_unconnected_input.hpp>
#include <cca/graph/diagnosis/rules/wires/wire_unknown_port.hpp>

namespace cca::detail {

// clang-format off
using rules = list<
    graph_unknown_item,
    node_bad_name,
    node_duplicate_name,
    skeleton_arity,
    component_no_process,
    component_bad_parameter,
    component_bad_result,
    component_hook_signature,
    parameters_unsupported_type,
    space_duplicate_axis,
    strategy_no_fires,
    strategy_unknown_port,
    strategy_misplaced,
    strategy_not_stoppable,
    part_unknown_path,
    wire_unknown_port,
    wire_direction,
    wire_two_writers,
    wire_bad_option,
    space_mismatch,
    learner_request,
    wire_bad_initial,
    wire_unconnected_input,
    observe_bad_policy,
    observe_nothing,
    plan_unknown_path,
    rate_missing,
    strategy_never_fires,
    graph_algebraic_loop,
    rate_mismatch,
    rate_unstated,
    queue_overflow,
    strategy_coordination,
    space_missing_limits,
    robot_unlimited_command,
    latency_exceeded
>;
// clang-format on

}  // namespace cca::detail
