// Step 2, connect: binds wires and observers to ports.
#pragma once

#include <cca/graph/diagnosis/check.hpp>
#include <cca/graph/plan/names.hpp>

namespace cca::detail {

struct connector {
  flat_view g;
  const table_entry* names;
  std::uint64_t mask;

  constexpr void connect(int writer, int reader, const item_info& item, int in_scope) {
    const finding facts{.item = &item, .scope = in_scope, .input = reader, .output = writer};
    const bool is_first = g.inputs[reader].writer < 0;
    if (!is_first && !goes_together(reader, writer, item)) return check<when::second_writer>(g, facts);
    check<when::connection>(g, facts);
    const int way = is_first ? reader : add_way(reader);
    auto& in = g.inputs[way];
    in.writer = writer;
    in.wired = true;
    in.wire = &item;
    in.delay = item.delay;
    if (item.initial && !g.inputs[reader].initial) g.inputs[reader].initial = &item;
    in.next_of_writer = g.outputs[writer].first_reader;
    g.outputs[writer].first_reader = way;
    if (!item.has_queue()) return;
    if (is_first) in.queue = g.queue_count++;
    if (item.full == full_kind::reject) g.may_fault = true;
  }

  // A further wire leads into the same queue, and brings other samples, or at other times.
  constexpr bool goes_together(int reader, int writer, const item_info& item) const {
    const auto& one = *g.inputs[reader].wire;
    bool is_new = true;
    for_each_way(g, reader, [&](const input& way) {
      is_new = is_new && !(way.writer == writer && way.delay == item.delay);
    });
    return is_new && one.policy == policy_kind::merged && item.policy == policy_kind::merged &&
           one.capacity == item.capacity && one.full == item.full;
  }
  constexpr int add_way(int reader) {
    const auto& in = g.inputs[reader];
    const int way = g.input_count++;
    g.inputs[way] = {.call = in.call, .port = in.port, .queue = in.queue, .way_of = reader};
    int last = reader;
    while (g.inputs[last].next_way >= 0) last = g.inputs[last].next_way;
    g.inputs[last].next_way = way;
    return way;
  }

  // In a graph without inner ones no other path has an entry.
  constexpr bool is_port(std::string_view path) const { return g.scope_count == 1 || names_port(path); }

  constexpr bool has(std::string_view path, std::uint64_t key) const {
    return is_port(path) && find(names, mask, key) >= 0;
  }

  constexpr void add_wire(const item_info& item, int in_scope) {
    const finding facts{.item = &item, .scope = in_scope};
    if (!item.unknown_type.empty() || item.repeats_option || item.too_small != policy_kind::unstated)
      check<when::wire_options>(g, facts);
    const auto& from = g.scopes[in_scope];
    const auto a = path_hash(from, item.from, item.from_hash), b = path_hash(from, item.to, item.to_hash);
    const int writer = is_port(item.from) ? find(names, mask, a ^ as_output) : -1;
    if (writer < 0) {
      const bool is_input = has(item.from, a ^ as_input);
      return check<when::unknown_port>(g, {.item = &item,
                                           .scope = in_scope,
                                           .is_opposite = is_input,
                                           .is_reversed = is_input && has(item.to, b ^ as_output)});
    }
    bool found = false;
    if (is_port(item.to)) {
      name_search readers(names, mask, b ^ as_input);
      for (int i = readers.next(); i >= 0; i = readers.next()) {
        found = true;
        connect(writer, i, item, in_scope);
      }
    }
    if (!found)
      check<when::unknown_port>(
          g,
          {.item = &item, .scope = in_scope, .at_reader = true, .is_opposite = has(item.to, b ^ as_output)});
  }

  // Does an observer hear this output? It names a path or a scope, as in `dmp.status.*`.
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
    // From the outermost name inwards: `*` is any one name, and at the end any path.
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
      if (!port.optional) {
        add_source(i, port.name, from);
        continue;
      }
      for (int o = 0; o < g.output_count && g.link_count < capacity; ++o)
        if (g.outputs[o].call != g.inputs[i].call && under(g.outputs[o], port.name, from)) {
          g.links[g.link_count++] = {i, o};
          g.inputs[i].wired = true;
        }
    }
  }

  // The one output that an observer names: in its own graph, else in the nearest graph around it.
  constexpr void add_source(int i, std::string_view path, int from) {
    for (int s = from; s >= 0; s = g.scopes[s].parent)
      if (const int o = find(names, mask, path_hash(g.scopes[s], path, hash(path)) ^ as_output); o >= 0) {
        g.links[g.link_count++] = {i, o};
        g.inputs[i].wired = true;
        return;
      }
  }

  // An `observe` among the items of a graph: what it names can be read between beats.
  constexpr void add_watch(const item_info& item, int in_scope) {
    bool found = false;
    for (int o = 0; o < g.output_count; ++o)
      if (under(g.outputs[o], item.from, in_scope)) found = g.outputs[o].watched = true;
    if (!found) check<when::unknown_port>(g, {.item = &item, .scope = in_scope});
  }

  // A part that a component stops or starts: in its own graph, else in the nearest graph around it.
  constexpr void find_part_of(part_request& request, std::string_view path) {
    const auto& t = g.calls[request.call];
    const bool from_outermost = path.starts_with('/');
    if (from_outermost) path.remove_prefix(1);
    const auto at = [&](int s) { return path_hash(g.scopes[s], path, hash(path)); };
    for (int s = from_outermost ? 0 : scope_of_call(g, t); s >= 0 && request.part < 0; s = g.scopes[s].parent)
      for (int p = 0; p < g.part_count && request.part < 0; ++p)
        if (g.parts[p].hash == at(s)) request.part = p;
    if (request.part < 0)
      check<when::unknown_part>(g, {.item = &item_of_call(g, t), .scope = scope_of_call(g, t), .name = path});
  }

  constexpr void run(int link_capacity) {
    for (int s = 0; s < g.scope_count; ++s) {
      const auto& graph = *g.scopes[s].graph;
      for (int i = 0; i < graph.count; ++i)
        if (graph.items[i].kind == item_kind::wire) add_wire(graph.items[i], s);
        else if (graph.items[i].kind == item_kind::observe) add_watch(graph.items[i], s);
    }
    add_observers(link_capacity);
    for (int r = 0; r < g.request_count; ++r) {
      const auto& t = g.calls[g.requests[r].call];
      find_part_of(g.requests[r], t.function->asked_parts[r - t.first_request].path);
    }
    for (int i = 0; i < g.input_count; ++i) {
      const auto& t = g.calls[g.inputs[i].call];
      if (!g.inputs[i].wired)
        check<when::open_input>(g, {.item = &item_of_call(g, t), .scope = scope_of_call(g, t), .input = i});
    }
  }
};

constexpr flat_view connect(flat_view g, const table_entry* names, std::uint64_t mask, int link_capacity) {
  connector step{g, names, mask};
  step.run(link_capacity);
  return step.g;
}

}  // namespace cca::detail
