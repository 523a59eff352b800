// Step 2, connect: binds wires to ports.
#pragma once

#include <cca/graph/diagnosis/rules/check.hpp>
#include <cca/graph/plan/names.hpp>

namespace cca::detail {

// An input reads an output over a wire.
constexpr void bind_wire(flat_view& g, int writer, int reader, const item_info& wire) {
  auto& in = g.inputs[reader];
  in.writer = writer;
  in.wired = true;
  in.wire = &wire;
  in.delay = wire.delay;
  in.next_of_writer = g.outputs[writer].first_reader;
  g.outputs[writer].first_reader = reader;
  if (wire.has_queue() && wire.full == full_kind::reject) g.may_fault = true;
}

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
    bind_wire(g, writer, way, item);
    if (item.initial && !g.inputs[reader].initial) g.inputs[reader].initial = &item;
    if (item.has_queue() && is_first) g.inputs[way].queue = g.queue_count++;
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

  constexpr void run() {
    for (int s = 0; s < g.scope_count; ++s) {
      const auto& graph = *g.scopes[s].graph;
      for (int i = 0; i < graph.count; ++i)
        if (graph.items[i].kind == item_kind::wire) add_wire(graph.items[i], s);
    }
    for (int r = 0; r < g.request_count; ++r) {
      const auto& t = g.calls[g.requests[r].call];
      find_part_of(g.requests[r], t.function->asked_parts[r - t.first_request].path);
    }
    for (int i = 0; i < g.input_count; ++i) {
      const auto& t = g.calls[g.inputs[i].call];
      if (!g.inputs[i].wired && port_of(g, g.inputs[i]).space)
        check<when::open_input>(g, {.item = &item_of_call(g, t), .scope = scope_of_call(g, t), .input = i});
    }
  }
};

constexpr flat_view connect(flat_view g, const table_entry* names, std::uint64_t mask) {
  connector step{g, names, mask};
  step.run();
  step.g.first_link = step.g.input_count;
  return step.g;
}

}  // namespace cca::detail
