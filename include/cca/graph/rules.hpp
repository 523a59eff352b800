// The rules, each with a stable id. The order is that in which they are looked at.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace cca::detail {

enum class rule : std::uint8_t {
  none,
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
  wire_unknown_port,
  wire_direction,
  wire_two_writers,
  wire_bad_option,
  wire_bad_initial,
  space_mismatch,
  wire_unconnected_input,
  rate_missing,
  strategy_never_fires,
  graph_algebraic_loop,
  rate_mismatch,
  rate_unstated,
  queue_overflow,
  strategy_coordination,
  space_missing_limits,
  robot_unlimited_command,
  latency_exceeded,
  count
};

inline constexpr std::array<std::string_view, static_cast<std::size_t>(rule::count)> rule_ids{
    "",
    "graph.unknown_item",
    "node.bad_name",
    "node.duplicate_name",
    "skeleton.arity",
    "component.no_process",
    "component.bad_parameter",
    "component.bad_result",
    "component.hook_signature",
    "parameters.unsupported_type",
    "space.duplicate_axis",
    "strategy.no_fires",
    "strategy.unknown_port",
    "strategy.misplaced",
    "wire.unknown_port",
    "wire.direction",
    "wire.two_writers",
    "wire.bad_option",
    "wire.bad_initial",
    "space.mismatch",
    "wire.unconnected_input",
    "rate.missing",
    "strategy.never_fires",
    "graph.algebraic_loop",
    "rate.mismatch",
    "rate.unstated",
    "queue.overflow",
    "strategy.coordination",
    "space.missing_limits",
    "robot.unlimited_command",
    "latency.exceeded",
};

struct item_info;

// The first broken rule and where: indices into the flat graph, by rule.
struct verdict {
  rule broken = rule::none;
  int a = -1, b = -1, c = -1;
  const item_info* item = nullptr;  // the item at fault
  int scope = 0;
};

}  // namespace cca::detail
