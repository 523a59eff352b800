// The message for a path of no component: `controller::get` and `controller::set` name one.
// Errors: node.unknown_path.
#pragma once

#include <type_traits>

#include <cca/graph/diagnosis.hpp>
#include <cca/graph/diagnosis/nearest_node.hpp>
#include <cca/graph/layout/nodes_by_path.hpp>

namespace cca::detail {

// `within`: the hash of the scope in which the path begins; 0: of the outermost graph. The message has the
// path from the outermost graph, and the nearest one that exists.
template <class Graph>
consteval text unknown_path(std::uint64_t within, std::string_view path) {
  auto plan = plan_of<Graph>;
  const flat_view g = plan.view();
  text wrong;
  for (int s = 1; within != 0 && s < counts_of<Graph>.scope_count; ++s)
    if (g.scopes[s].hash == within) add_scope_path(wrong, g, s);
  wrong << path;
  const text nearest = nearest_node(g, wrong.view());
  text said;
  said << "node.unknown_path: " << graph_facts<Graph>::value.name << " has no node `" << wrong.view() << "`";
  if (nearest.size > 0) said << "; did you mean `" << nearest.view() << "`?";
  else said << ": give the path of a node, from the outermost graph, as in `skills.gait`";
  return said;
}

template <class Graph, std::uint64_t Within, fixed_string Path>
inline constexpr text path_report = unknown_path<Graph>(Within, Path.view());
template <class Graph, std::uint64_t Within, fixed_string Path>
struct said_of_path {
  static constexpr std::string_view view() { return path_report<Graph, Within, Path>.view(); }
};
template <class Graph, std::uint64_t Within, fixed_string Path>
using path_refusal = printed<said_of_path<Graph, Within, Path>>;

// A function of the message alone: else the compiler may print the names of aliases, and their arguments,
// before it.
template <class Refusal>
constexpr void report_path() {
  static_assert(sizeof(Refusal) != 0);
}

// True if there is a component, or an inner graph, at the path; else it reports the mistake.
template <class Graph, std::uint64_t Within, fixed_string Path, std::uint64_t Whole>
constexpr auto check_path() {
  constexpr bool found = node_with_hash<Graph>(Whole) >= 0 || has_scope<Graph>(Whole);
  if constexpr (!found) report_path<path_refusal<Graph, Within, Path>>();
  return std::bool_constant<found>{};
}

// The type of the parameters at a path. Where there are none it takes anything, so that there is one error.
template <class Graph, fixed_string Path>
constexpr bool can_set() {
  constexpr int node = node_at<Graph>(Path.view());
  if constexpr (node < 0) return false;
  else return requires { typename node_types<Graph, node>::component::parameters; };
}
template <class Graph, fixed_string Path>
struct parameters_at {
  static constexpr auto path = hash(Path.view());
  static constexpr bool exists = node_with_hash<Graph>(path) >= 0 || has_scope<Graph>(path);
  static_assert(decltype(check_path<Graph, 0, Path, path>())::value || true);
  static_assert(!exists, "cca::controller::set: this node has no `parameters`; name a component that has");
  struct type {
    template <class... Values>
    constexpr type(Values&&...) {}
  };
};
template <class Graph, fixed_string Path>
  requires(can_set<Graph, Path>())
struct parameters_at<Graph, Path> {
  using type = typename node_types<Graph, node_at<Graph>(Path.view())>::component::parameters;
};

}  // namespace cca::detail
