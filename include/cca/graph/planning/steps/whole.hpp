// Step 9, check the whole: asks the rules that need the finished plan.
#pragma once

#include <cca/graph/diagnosis/rules/check.hpp>
#include <cca/graph/plan/names.hpp>

namespace cca::detail {

// `require<latency<...>, beats<...>>` among the items of a graph.
constexpr void check_latency(
    flat_view& g, const table_entry* names, std::uint64_t mask, const item_info& item, int in_scope) {
  const auto& s = g.scopes[in_scope];
  const auto key = [&](std::string_view path) { return path_hash(s, path, hash(path)); };
  const int output = names_port(item.from) ? find(names, mask, key(item.from) ^ as_output) : -1;
  if (output < 0) return check<when::unknown_port>(g, {.item = &item, .scope = in_scope});
  bool found = false;
  name_search readers(names, mask, key(item.to) ^ as_input);
  for (int i = names_port(item.to) ? readers.next() : -1; i >= 0; i = readers.next()) {
    found = true;
    check<when::stated_latency>(g, {.item = &item, .scope = in_scope, .input = i, .output = output});
  }
  if (!found) check<when::unknown_port>(g, {.item = &item, .scope = in_scope, .at_reader = true});
}

constexpr flat_view check_whole(flat_view g, const table_entry* names, std::uint64_t mask) {
  check_calls<when::finished_call>(g);
  for (int i = 0; i < g.input_count; ++i) {
    const auto& t = g.calls[g.inputs[i].call];
    if (port_of(g, g.inputs[i]).space)
      check<when::finished_input>(g, {.item = &item_of_call(g, t), .scope = scope_of_call(g, t), .input = i});
  }
  for (int s = 0; s < g.scope_count; ++s)
    for (int i = 0; i < g.scopes[s].graph->count; ++i)
      if (g.scopes[s].graph->items[i].kind == item_kind::require)
        check_latency(g, names, mask, g.scopes[s].graph->items[i], s);
  return g;
}

}  // namespace cca::detail
