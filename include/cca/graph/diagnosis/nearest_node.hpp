// "Did you mean ...": the node of a graph whose path is nearest to a wrong one.
#pragma once

#include <algorithm>

#include <cca/base/nearest.hpp>
#include <cca/graph/plan/paths.hpp>

namespace cca::detail {

// Components and inner graphs, by their paths from the outermost graph; empty if none is near.
constexpr text nearest_node(const flat_view& g, std::string_view wrong) {
  text nearest;
  auto least = std::max<std::size_t>(1, wrong.size() / 3) + 1;
  const auto consider = [&](const text& candidate) {
    if (const auto distance = edit_distance(wrong, candidate.view()); distance < least) {
      least = distance;
      nearest = candidate;
    }
  };
  for (int n = 0; n < g.node_count; ++n) {
    text candidate;
    add_node_path(candidate, g, n);
    consider(candidate);
  }
  for (int s = 1; s < g.scope_count; ++s) {
    if (!g.scopes[s].item) continue;  // the outermost graph of a mode
    text candidate;
    add_scope_path(candidate, g, s);
    --candidate.size;  // the dot
    consider(candidate);
  }
  return nearest;
}

}  // namespace cca::detail
