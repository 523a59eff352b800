// Second step: wires and observers bound to ports. Checks paths, directions, writers and spaces.
#pragma once

#include <cca/graph/names.hpp>

namespace cca::detail {

struct wiring {
  flat_view g;
  const table_entry* names;
  std::uint64_t mask;

  constexpr void refuse(rule broken, const item_info* item, int scope, int a = -1, int b = -1) {
    if (g.found.broken == rule::none) g.found = {broken, a, b, -1, item, scope};
  }

  constexpr void connect(int writer, int reader, const item_info* item, int in_scope) {
    auto& i = g.inputs[reader];
    if (i.writer >= 0) return refuse(rule::wire_two_writers, item, in_scope, reader, writer);
    i.writer = writer;
    i.wired = true;
    i.wire = item;
    if (item->policy == policy_kind::delayed) i.delay = item->number;
    i.next_of_writer = g.outputs[writer].first_reader;
    g.outputs[writer].first_reader = reader;
    const auto& from = *port_of(g, g.outputs[writer]).space;
    const auto& to = *port_of(g, i).space;
    if (!matches(from, to)) return refuse(rule::space_mismatch, item, in_scope, writer, reader);
    if (item->initial && item->initial_count != 1 && item->initial_count != to.size)
      refuse(rule::wire_bad_initial, item, in_scope, reader);
    if (item->policy == policy_kind::queue) i.queue = g.queue_count++;
    if (item->policy == policy_kind::queue && item->full == full_kind::reject) g.may_fault = true;
  }

  // In a graph without inner ones no other path has an entry.
  constexpr bool is_port(std::string_view path) const { return g.scope_count == 1 || names_port(path); }

  constexpr void add_wire(const item_info& item, int in_scope) {
    if (!item.unknown_type.empty() || item.repeats_option) refuse(rule::wire_bad_option, &item, in_scope);
    const auto& from = g.scopes[in_scope];
    const auto a = path_hash(from, item.from, item.from_hash), b = path_hash(from, item.to, item.to_hash);
    const int writer = is_port(item.from) ? find(names, mask, a ^ as_output) : -1;
    if (writer < 0) {
      const bool is_input = is_port(item.from) && find(names, mask, a ^ as_input) >= 0;
      const bool reversed = is_input && is_port(item.to) && find(names, mask, b ^ as_output) >= 0;
      return refuse(is_input ? rule::wire_direction : rule::wire_unknown_port, &item, in_scope, 0, reversed);
    }
    bool found = false;
    if (is_port(item.to)) {
      name_search readers(names, mask, b ^ as_input);
      for (int i = readers.next(); i >= 0; i = readers.next()) {
        found = true;
        connect(writer, i, &item, in_scope);
      }
    }
    if (!found) {
      const bool is_output = is_port(item.to) && find(names, mask, b ^ as_output) >= 0;
      refuse(is_output ? rule::wire_direction : rule::wire_unknown_port, &item, in_scope, 1);
    }
  }

  // Does the path of an output begin with the names of a scope, as in `dmp.status.*`?
  constexpr bool under(const output& o, std::string_view listened, int observer_scope) const {
    const auto& t = g.calls[o.call];
    const auto& l = g.nodes[t.node];
    std::array<std::string_view, 34> path{};
    int length = 0;
    path[static_cast<std::size_t>(length++)] = port_of(g, o).name;
    path[static_cast<std::size_t>(length++)] = l.item->from;
    int s = l.scope;
    for (; s != observer_scope && s >= 0; s = g.scopes[s].parent) {
      if (g.scopes[s].item && length < 34) path[static_cast<std::size_t>(length++)] = g.scopes[s].item->from;
    }
    if (s != observer_scope) return false;
    // Name by name from the outermost: `*` is any one name, at the end whatever follows.
    for (std::string_view rest = listened;;) {
      std::size_t dot = 0;
      while (dot < rest.size() && rest[dot] != '.') ++dot;
      const auto word = rest.substr(0, dot);
      if (dot == rest.size()) return word == "*" ? length > 0 : length == 1 && word == path[0];
      if (length == 0) return false;
      --length;
      if (word != "*" && word != path[static_cast<std::size_t>(length)]) return false;
      rest.remove_prefix(dot + 1);
    }
  }

  constexpr void add_observers(int capacity) {
    for (int i = 0; i < g.input_count; ++i) {
      const auto& port = port_of(g, g.inputs[i]);
      if (port.space) continue;
      const int from = g.nodes[g.calls[g.inputs[i].call].node].scope;
      for (int o = 0; o < g.output_count && g.link_count < capacity; ++o)
        if (g.outputs[o].call != g.inputs[i].call && under(g.outputs[o], port.name, from)) {
          g.links[g.link_count++] = {i, o};
          g.inputs[i].wired = true;
        }
    }
  }

  // An `observe` among the items of a graph: what it names stays readable between beats.
  constexpr void add_watch(const item_info& item, int in_scope) {
    bool found = false;
    for (int o = 0; o < g.output_count; ++o)
      if (under(g.outputs[o], item.from, in_scope)) found = g.outputs[o].watched = true;
    if (!found) refuse(rule::wire_unknown_port, &item, in_scope, 0);
  }

  constexpr void run(int link_capacity) {
    for (int s = 0; s < g.scope_count; ++s) {
      const auto& graph = *g.scopes[s].graph;
      for (int i = 0; i < graph.count; ++i)
        if (graph.items[i].kind == item_kind::wire) add_wire(graph.items[i], s);
        else if (graph.items[i].kind == item_kind::observe) add_watch(graph.items[i], s);
    }
    add_observers(link_capacity);
    for (int i = 0; i < g.input_count; ++i)
      if (!g.inputs[i].wired && !port_of(g, g.inputs[i]).optional)
        refuse(rule::wire_unconnected_input, &item_of_call(g, g.calls[g.inputs[i].call]),
               g.nodes[g.calls[g.inputs[i].call].node].scope, i);
  }
};

}  // namespace cca::detail
