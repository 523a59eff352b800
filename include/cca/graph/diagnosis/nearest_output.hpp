// An output by its path, and the one that the user probably meant. Paths may lead through what inner graphs
// expose, as those of wires.
#pragma once

#include <string_view>

#include <cca/base/nearest.hpp>
#include <cca/graph/plan/paths.hpp>

namespace cca::detail {

// The number of the output with this path; -1: there is none.
constexpr int output_named(const flat_view& g, std::string_view path) {
  for (int o = 0; o < g.output_count - g.taken_count; ++o) {
    text known;
    add_port(known, g, g.outputs[o]);
    if (known.view() == path) return o;
  }
  for (int s = 1; s < g.scope_count; ++s) {
    if (!g.scopes[s].item) continue;  // the outermost graph of a mode
    text inner;
    add_scope_path(inner, g, s);
    if (!path.starts_with(inner.view())) continue;
    const std::string_view name = path.substr(inner.size);
    for (int i = 0; i < g.scopes[s].graph->count; ++i)
      if (const auto& item = g.scopes[s].graph->items[i]; item.kind == item_kind::expose && item.to == name)
        return output_named(g, (inner << item.from).view());
  }
  return -1;
}

// Of all outputs, and of those that an inner graph exposes; empty if none is near.
constexpr text nearest_output(const flat_view& g, std::string_view wrong) {
  text nearest;
  std::size_t least = wrong.size() / 3 + 2;
  const auto consider = [&](const text& candidate) {
    const auto size = candidate.size;
    if ((size < wrong.size() ? wrong.size() - size : size - wrong.size()) >= least) return;
    if (const auto distance = edit_distance(wrong, candidate.view()); distance < least) {
      least = distance;
      nearest = candidate;
    }
  };
  for (int s = 1; s < g.scope_count; ++s) {
    if (!g.scopes[s].item) continue;
    for (int i = 0; i < g.scopes[s].graph->count; ++i) {
      const auto& item = g.scopes[s].graph->items[i];
      if (item.kind != item_kind::expose) continue;
      text candidate;
      add_scope_path(candidate, g, s);
      candidate << item.to;
      if (output_named(g, candidate.view()) >= 0) consider(candidate);
    }
  }
  for (int o = 0; o < g.output_count - g.taken_count; ++o) {
    text candidate;
    add_port(candidate, g, g.outputs[o]);
    consider(candidate);
  }
  return nearest;
}

}  // namespace cca::detail
