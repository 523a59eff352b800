// Components and inner graphs by path.
#pragma once

#include <cca/graph/layout/types.hpp>

namespace cca::detail {

template <class Graph>
constexpr int node_with_hash(std::uint64_t path) {
  for (int i = 0; i < counts_of<Graph>.node_count; ++i) {
    const auto& l = plan_of<Graph>.nodes[static_cast<std::size_t>(i)];
    const auto& s = plan_of<Graph>.scopes[static_cast<std::size_t>(l.scope)];
    if (path_hash(s, l.item->from, l.item->from_hash) == path) return i;
  }
  return -1;
}

template <class Graph>
constexpr int node_at(std::string_view path) {
  return node_with_hash<Graph>(hash(path));
}

template <class Graph>
constexpr bool has_scope(std::uint64_t path) {
  for (int s = 1; s < counts_of<Graph>.scope_count; ++s)
    if (plan_of<Graph>.scopes[static_cast<std::size_t>(s)].hash == path) return true;
  return false;
}

// The time between two firings of a node in s. A clock that is known only at run time counts as every beat.
template <class Graph>
constexpr double step_of(int node) {
  std::int64_t beats = 1;
  for (int i = 0; i < counts_of<Graph>.call_count; ++i) {
    const auto& one = plan_of<Graph>.calls[static_cast<std::size_t>(i)];
    if (one.node == node) beats = one.own_clock.known() ? one.own_clock.period : one.longest_period;
  }
  return 1e-9 * static_cast<double>(beats * counts_of<Graph>.period);
}

}  // namespace cca::detail
