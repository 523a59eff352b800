// Step 1, flatten: components, functions and ports of all inner graphs go into arrays, their paths into a
// table of names. Asks the rules about what a component shows by itself.
#pragma once

#include <string_view>
#include <type_traits>
#include <utility>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/component/parameters.hpp>
#include <cca/graph/diagnosis/rules/check.hpp>
#include <cca/graph/plan/names.hpp>

namespace cca::detail {

// A graph with a mistake of its own states the sentence as `cca_refused_by`, and asserts it (holds_or_tells).
// The graphs around it are refused by the same sentence, and print nothing.
template <class Graph>
struct refused_by_itself {
  static constexpr void (*in_graph)(flat_view&, int) = nullptr;
};
template <class Graph>
  requires(!std::is_void_v<typename Graph::cca_refused_by>)
struct refused_by_itself<Graph> {
  static constexpr std::string_view sentence = told<typename Graph::cca_refused_by>::view();
  static constexpr std::string_view rule = sentence.substr(0, sentence.find(':'));

  static constexpr void in_graph(flat_view& g, int scope) {
    if (!g.found.is_broken()) g.found = {.rule = rule, .scope = scope, .tell = &tell, .is_told = true};
  }
  static constexpr void tell(message_writer& m) {
    add_scope_path(m.where, m.g, m.found().scope);
    m.say() << sentence.substr(rule.size() + 2);
  }
};

struct flattener {
  flat_view g;
  name_table names;
  std::uint64_t last_sound = 0;  // type of the last component without a mistake: it is not checked again
  bool is_sound = false;         // the component at hand is of that type

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
      const int number = g.input_count++;
      g.inputs[number] = {.call = call_index, .port = p};
      if (!port.space) continue;
      if (!is_sound)
        check<when::component_port>(g,
                                    {.item = &item, .scope = in_scope, .input = number, .name = port.name});
      if (!names.add(hash(port.name, base) ^ as_input, number))
        check<when::repeated_port>(g, {.item = &item, .scope = in_scope, .input = number, .name = port.name});
    }
    for (int p = 0; p < function.output_count; ++p) {
      const auto& port = function.outputs[p];
      const int number = g.output_count++;
      g.outputs[number] = {.call = call_index, .port = p};
      if (!is_sound)
        check<when::component_port>(g,
                                    {.item = &item, .scope = in_scope, .output = number, .name = port.name});
      if (!names.add(hash(port.name, base) ^ as_output, number))
        check<when::repeated_port>(g,
                                   {.item = &item, .scope = in_scope, .output = number, .name = port.name});
    }
  }

  constexpr void add_function(const function_info& function,
                              phase_of_beat phase,
                              component_node& node,
                              int node_index,
                              const item_info& item,
                              std::uint64_t node_hash) {
    if (!is_sound)
      check<when::component_function>(g, {.item = &item, .scope = node.scope, .function = &function});
    g.may_fault |= function.may_fault;
    const int call_index = g.call_count++;
    g.calls[call_index] = {
        .node = node_index, .phase = phase, .function = &function, .first_request = g.request_count};
    for (int r = 0; r < function.asked_count; ++r)
      g.requests[g.request_count++] = {.call = call_index, .starts = function.asked_parts[r].starts};
    ++node.call_count;
    add_ports(function, call_index, item, node.scope, node_hash);
  }

  constexpr void add_component(const item_info& item, int in_scope, std::uint64_t node_hash) {
    const auto& component = *item.component;
    const int node_index = g.node_count++;
    auto& node = g.nodes[node_index];
    const int part = part_of(item, in_scope, node_hash);
    node = {.item = &item, .scope = in_scope, .first_call = g.call_count, .part = part};
    if (part >= 0) check<when::node_of_part>(g, {.item = &item, .scope = in_scope});
    is_sound = component.key == last_sound;
    if (!is_sound) check<when::component_kind>(g, {.item = &item, .scope = in_scope});
    if (component.sense)
      add_function(*component.sense, phase_of_beat::sense, node, node_index, item, node_hash);
    if (component.process)
      add_function(*component.process, phase_of_beat::process, node, node_index, item, node_hash);
    if (component.act) add_function(*component.act, phase_of_beat::act, node, node_index, item, node_hash);
    if (!is_sound) check<when::whole_component>(g, {.item = &item, .scope = in_scope});
    if (!g.found.is_broken()) last_sound = component.key;
    if (item.strategy) check<when::stated_strategy>(g, {.item = &item, .scope = in_scope});
  }

  // A port that a graph exposes gets a second entry in the table, under the name of the graph.
  constexpr void add_expose(const item_info& item, int in_scope) {
    const auto& from = g.scopes[in_scope];
    const auto inner = from.parent < 0 ? hash(item.from) : hash(item.from, after_dot(from.hash));
    const auto outer =
        from.parent < 0 ? hash(item.to, hash(".outside.")) : hash(item.to, after_dot(from.hash));
    const finding facts{.item = &item, .scope = in_scope};
    bool found = false;
    check<when::exposed_name>(g, facts);
    if (names_port(item.from)) {
      name_search writers(names.entries, names.mask, inner ^ as_output);
      for (int o = writers.next(); o >= 0; o = writers.next()) {
        found = true;
        if (!names.add(outer ^ as_output, o)) check<when::repeated_name>(g, facts);
      }
      name_search readers(names.entries, names.mask, inner ^ as_input);
      for (int i = readers.next(); i >= 0; i = readers.next()) {
        found = true;
        names.insert(outer ^ as_input, i);
        if (from.parent < 0) g.inputs[i].wired = true;
      }
    }
    if (!found) check<when::unknown_port>(g, facts);
  }

  // The innermost part of a node: itself, if it may be stopped, or that of the graph around it.
  constexpr int part_of(const item_info& item, int in_scope, std::uint64_t node_hash) {
    const int around = g.scopes[in_scope].part;
    if (!item.is_stoppable()) return around;
    g.parts[g.part_count] = {.parent = around, .item = &item, .scope = in_scope, .hash = node_hash};
    return g.part_count++;
  }

  constexpr void add_graph(
      const graph_info& graph, int parent, ref<item_info> item, std::uint64_t scope_hash, int own_part = -1) {
    const int index = g.scope_count++;
    g.scopes[index] = {parent, item, &graph, scope_hash, own_part};
    if (graph.refuse) graph.refuse(g, index);
    for (int i = 0; i < graph.count; ++i) {
      const auto& part = graph.items[i];
      const finding facts{.item = &part, .scope = index};
      if (part.kind == item_kind::unknown) check<when::any_item>(g, facts);
      if (part.kind != item_kind::node && part.kind != item_kind::graph) continue;
      check<when::named_node>(g, facts);
      if (facts.item->inner && facts.item->inner->refuse_as_node) facts.item->inner->refuse_as_node(g, facts);
      const auto node_hash = path_hash(g.scopes[index], part.from, part.from_hash);
      if (!names.add(node_hash ^ as_node, 0)) check<when::repeated_name>(g, facts);
      if (part.kind == item_kind::node) {
        add_component(part, index, node_hash);
      } else {
        if (part.strategy) check<when::stated_strategy>(g, facts);
        add_graph(*part.inner, index, &part, node_hash, part_of(part, index, node_hash));
      }
    }
    for (int i = 0; i < graph.count; ++i)
      if (graph.items[i].kind == item_kind::expose) add_expose(graph.items[i], index);
  }
};

// The names table is filled beside the flat graph.
constexpr flat_view flatten(flat_view g, const graph_info& graph, name_table names) {
  flattener step{g, names};
  step.add_graph(graph, -1, nullptr, hash(""));
  return step.g;
}

}  // namespace cca::detail
