// Step 3, find the rate: the length of a beat, from the outermost graph, or else from the fastest of its
// spaces.
#pragma once

#include <cca/graph/diagnosis/rules/check.hpp>

namespace cca::detail {

constexpr flat_view find_rate(flat_view g) {
  const auto for_each_rate = [&](int s, auto f) {
    for (int i = 0; i < g.scopes[s].graph->count; ++i)
      if (const auto& item = g.scopes[s].graph->items[i]; item.kind == item_kind::rate) f(item);
  };
  for (int s = 0; s < g.scope_count; ++s)
    for_each_rate(s,
                  [&](const item_info& item) { check<when::stated_rate>(g, {.item = &item, .scope = s}); });
  if (g.found.is_broken()) return g;
  for_each_rate(0, [&](const item_info& item) {
    if (g.hz > 0) check<when::second_rate>(g, {.item = &item});
    else g.hz = item.hz;
  });
  if (g.hz == 0) {
    for (int i = 0; i < g.input_count; ++i)
      if (const auto space = port_of(g, g.inputs[i]).space; space && space->hz > g.hz) g.hz = space->hz;
    for (int o = 0; o < g.output_count - g.taken_count; ++o)
      if (const auto space = port_of(g, g.outputs[o]).space; space->hz > g.hz) g.hz = space->hz;
  }
  check<when::known_rate>(g, {});
  if (g.found.is_broken()) return g;
  g.period = static_cast<std::int64_t>(1e9 / g.hz);
  for (int s = 1; s < g.scope_count; ++s)
    for_each_rate(s,
                  [&](const item_info& item) { check<when::second_rate>(g, {.item = &item, .scope = s}); });
  return g;
}

}  // namespace cca::detail
