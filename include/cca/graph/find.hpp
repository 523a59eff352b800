// Components and inner graphs by path.
#pragma once

#include <cca/graph/types.hpp>

namespace cca::detail {

template <class Graph>
constexpr int leaf_with_hash(std::uint64_t path) {
  for (int i = 0; i < counts_of<Graph>.leaf_count; ++i) {
    const auto& l = plan_of<Graph>.leaves[static_cast<std::size_t>(i)];
    const auto& s = plan_of<Graph>.scopes[static_cast<std::size_t>(l.scope)];
    if (path_hash(s, l.item->from, l.item->from_hash) == path) return i;
  }
  return -1;
}

template <class Graph>
constexpr int leaf_at(std::string_view path) { return leaf_with_hash<Graph>(hash(path)); }

template <class Graph>
constexpr bool has_scope(std::uint64_t path) {
  for (int s = 1; s < counts_of<Graph>.scope_count; ++s)
    if (plan_of<Graph>.scopes[static_cast<std::size_t>(s)].hash == path) return true;
  return false;
}

template <class Graph, int Leaf>
struct parameters_at { using type = typename leaf_of<Graph, Leaf>::component::parameters; };
template <class Graph>
struct parameters_at<Graph, -1> {
  static_assert(sizeof(Graph) == 0, "cca::controller::set: no component has this path");
  struct type {};
};

}  // namespace cca::detail
