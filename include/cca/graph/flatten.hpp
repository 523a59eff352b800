// First step: components, functions and ports of all inner graphs into arrays, their paths into the table.
// Checks what can be seen of a component alone.
#pragma once

#include <utility>

#include <cca/component/parameters.hpp>
#include <cca/graph/names.hpp>

namespace cca::detail {

struct flattening {
  flat_view g;
  name_table names;
  std::uint64_t last_sound = 0;  // type of the last component without fault: others of it need no second look
  bool is_sound = false;         // the component at hand is of it

  constexpr void refuse(rule broken, const item_info* item, int scope, int a = -1, int b = -1) {
    if (g.found.broken == rule::none) g.found = {broken, a, b, -1, item, scope};
  }

  constexpr void add_ports(const function_info& function,
                           int call_index,
                           const item_info& item,
                           int in_scope,
                           std::uint64_t node_hash) {
    auto& t = g.calls[call_index];
    t.first_input = g.input_count;
    t.first_output = g.output_count;
    const auto base = after_dot(node_hash);
    for (int p = 0; p < function.input_count; ++p) {
      const auto& port = function.inputs[p];
      if (!is_sound) check_port(port, item, in_scope, 0);
      if (port.space && !names.add(hash(port.name, base) ^ as_input, g.input_count))
        refuse(rule::component_bad_parameter, &item, in_scope, p, 1);
      g.inputs[g.input_count++] = {.call = call_index, .port = p};
    }
    for (int p = 0; p < function.output_count; ++p) {
      const auto& port = function.outputs[p];
      if (!is_sound) check_port(port, item, in_scope, 1);
      if (!names.add(hash(port.name, base) ^ as_output, g.output_count))
        refuse(rule::component_bad_result, &item, in_scope, p, 1);
      g.outputs[g.output_count++] = {.call = call_index, .port = p};
    }
  }

  constexpr void check_port(const port_info& port, const item_info& item, int in_scope, int is_output) {
    if (!port.space) return;
    if (!is_name(port.name)) refuse(rule::node_bad_name, &item, in_scope, 1);
    if (port.space->duplicate_axis >= 0)
      refuse(rule::space_duplicate_axis, &item, in_scope, is_output ? g.output_count : g.input_count,
             is_output);
  }

  constexpr void add_function(const function_info& function,
                              phase_of_beat phase,
                              component_node& l,
                              int node_index,
                              const item_info& item,
                              std::uint64_t node_hash) {
    if (!is_sound) check_function(function, item, l.scope);
    g.may_fault |= function.may_fault;
    const int call_index = g.call_count++;
    g.calls[call_index] = {.node = node_index, .phase = phase, .function = &function};
    ++l.call_count;
    add_ports(function, call_index, item, l.scope, node_hash);
  }

  constexpr void check_function(const function_info& function, const item_info& item, int in_scope) {
    if (!function.bad_parameter.empty()) refuse(rule::component_bad_parameter, &item, in_scope);
    if (!function.bad_result.empty()) refuse(rule::component_bad_result, &item, in_scope);
  }

  constexpr bool has_input(const item_info& item, std::string_view name) const {
    for (const auto function : {item.component->process, item.component->act, item.component->sense})
      for (int p = 0; function && p < function->input_count; ++p)
        if (function->inputs[p].name == name) return true;
    return false;
  }

  constexpr void check_strategy(const strategy_info& strategy, const item_info& item, int in_scope) {
    for (const auto name : strategy.named_inputs)
      if (!has_input(item, name)) {
        refuse(rule::strategy_unknown_port, &item, in_scope);
        if (g.found.item == &item && g.found.broken == rule::strategy_unknown_port && unknown_trigger.empty())
          unknown_trigger = name;
      }
    for (int i = 0; i < strategy.part_count; ++i) check_strategy(*strategy.parts[i], item, in_scope);
  }
  std::string_view unknown_trigger{};

  constexpr void check_kind(const component_info& component, const item_info& item, int in_scope) {
    if (!component.wrong_arity.empty()) refuse(rule::skeleton_arity, &item, in_scope);
    if (!component.process && !component.resource()) refuse(rule::component_no_process, &item, in_scope, 0);
    if (component.also_sense || component.also_act) refuse(rule::component_no_process, &item, in_scope, 1);
    if (component.is_const) refuse(rule::component_no_process, &item, in_scope, 2);
  }

  constexpr void add_component(const item_info& item, int in_scope, std::uint64_t node_hash) {
    const auto& component = *item.component;
    const int node_index = g.node_count++;
    auto& l = g.nodes[node_index];
    l = {.item = &item, .scope = in_scope, .first_call = g.call_count};
    is_sound = component.key == last_sound;
    if (!is_sound) check_kind(component, item, in_scope);
    if (component.sense) add_function(*component.sense, phase_of_beat::sense, l, node_index, item, node_hash);
    if (component.process)
      add_function(*component.process, phase_of_beat::process, l, node_index, item, node_hash);
    if (component.act) add_function(*component.act, phase_of_beat::act, l, node_index, item, node_hash);
    if (!is_sound && !component.bad_hook.empty()) refuse(rule::component_hook_signature, &item, in_scope);
    if (!is_sound && (!component.bad_field.empty() || component.forgot_parameters))
      refuse(rule::parameters_unsupported_type, &item, in_scope);
    if (g.found.broken == rule::none) last_sound = component.key;
    if (!item.strategy) return;
    if (!item.unknown_type.empty()) refuse(rule::strategy_no_fires, &item, in_scope);
    check_strategy(*item.strategy, item, in_scope);
    if (component.resource() && !item.strategy->for_resource_nodes)
      refuse(rule::strategy_misplaced, &item, in_scope);
  }

  // What a graph exposes is found under the graph's own name.
  constexpr void add_expose(const item_info& item, int in_scope) {
    const auto& from = g.scopes[in_scope];
    const auto inner = from.parent < 0 ? hash(item.from) : hash(item.from, after_dot(from.hash));
    const auto outer =
        from.parent < 0 ? hash(item.to, hash(".outside.")) : hash(item.to, after_dot(from.hash));
    bool found = false;
    if (!is_name(item.to)) refuse(rule::node_bad_name, &item, in_scope, 2);
    if (names_port(item.from)) {
      name_search writers(names.entries, names.mask, inner ^ as_output);
      for (int o = writers.next(); o >= 0; o = writers.next()) {
        found = true;
        if (!names.add(outer ^ as_output, o)) refuse(rule::node_duplicate_name, &item, in_scope, 1);
      }
      name_search readers(names.entries, names.mask, inner ^ as_input);
      for (int i = readers.next(); i >= 0; i = readers.next()) {
        found = true;
        names.insert(outer ^ as_input, i);
        if (from.parent < 0) g.inputs[i].wired = true;
      }
    }
    if (!found) refuse(rule::wire_unknown_port, &item, in_scope, 0);
  }

  constexpr void add_graph(const graph_info& graph,
                           int parent,
                           ref<item_info> item,
                           std::uint64_t scope_hash) {
    const int index = g.scope_count++;
    g.scopes[index] = {parent, item, &graph, scope_hash};
    for (int i = 0; i < graph.count; ++i) {
      const auto& part = graph.items[i];
      if (part.kind == item_kind::unknown) refuse(rule::graph_unknown_item, &part, index);
      if (part.kind != item_kind::node && part.kind != item_kind::graph) continue;
      if (!is_name(part.from)) refuse(rule::node_bad_name, &part, index, 0);
      const auto node_hash = path_hash(g.scopes[index], part.from, part.from_hash);
      if (!names.add(node_hash ^ as_node, 0)) refuse(rule::node_duplicate_name, &part, index, 0);
      if (part.kind == item_kind::node) {
        add_component(part, index, node_hash);
      } else {
        if (part.strategy) refuse(rule::strategy_misplaced, &part, index);
        add_graph(*part.inner, index, &part, node_hash);
      }
    }
    for (int i = 0; i < graph.count; ++i)
      if (graph.items[i].kind == item_kind::expose) add_expose(graph.items[i], index);
  }
};

}  // namespace cca::detail
