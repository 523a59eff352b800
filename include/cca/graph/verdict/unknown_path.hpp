// The message for a path of no component: `controller::get` and `controller::set` name one.
// Errors: node.unknown_path.
#pragma once

#include <type_traits>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/graph/verdict/diagnosis.hpp>
#include <cca/graph/diagnosis/nearest_node.hpp>
#include <cca/graph/layout/nodes_by_path.hpp>

namespace cca::detail {

struct path_report {
  text said{};
  std::uint64_t nearest = 0;  // hash of the path that the user probably meant
};

// `within`: the hash of the scope in which the path begins; 0: of the outermost graph. The message has the
// path from the outermost graph, and the nearest one that exists.
template <class Graph>
consteval path_report unknown_path(std::uint64_t within, std::string_view path) {
  const auto& plan = plan_of<Graph>;
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
  return {said, hash(nearest.view())};
}

template <class Graph, std::uint64_t Within, fixed_string Path>
inline constexpr path_report report_of_path = unknown_path<Graph>(Within, Path.view());
template <class Graph, std::uint64_t Within, fixed_string Path>
struct said_of_path {
  static constexpr std::string_view view() { return report_of_path<Graph, Within, Path>.said.view(); }
};

template <std::uint64_t Within, fixed_string Path>
inline constexpr std::uint64_t whole_path =
    Within == 0 ? hash(Path.view()) : hash(Path.view(), after_dot(Within));

template <class Graph>
constexpr bool has_path(std::uint64_t path) {
  return node_with_hash<Graph>(path) >= 0 || has_scope<Graph>(path);
}

// Of an unknown path a type without a size, which is the message. Whoever takes a path asserts the size in
// the function that the user calls: the compilers list each function between that and the mistake, and a
// function without a result may be looked at only after what follows from the mistake.
template <class Graph, std::uint64_t Within, fixed_string Path>
struct refusal_of_path {
  using type = printed<said_of_path<Graph, Within, Path>>;
};
template <class Graph, std::uint64_t Within, fixed_string Path>
  requires(has_path<Graph>(whole_path<Within, Path>))
struct refusal_of_path<Graph, Within, Path> {
  using type = char;
};
template <class Graph, std::uint64_t Within, fixed_string Path>
using path_refusal = typename refusal_of_path<Graph, Within, Path>::type;

// The path; if there is no such component or inner graph, the one that the user probably meant: so no error
// follows from the mistake.
template <class Graph, std::uint64_t Within, fixed_string Path>
constexpr std::uint64_t known_path() {
  if constexpr (has_path<Graph>(whole_path<Within, Path>)) return whole_path<Within, Path>;
  else return report_of_path<Graph, Within, Path>.nearest;
}

template <class Graph, fixed_string Path>
constexpr bool can_set() {
  constexpr int node = node_at<Graph>(Path.view());
  if constexpr (node < 0) return false;
  else return requires { typename node_types<Graph, node>::component::parameters; };
}
template <class Graph, fixed_string Path>
constexpr void tell_node_at(text& m) {
  constexpr int node = node_at<Graph>(Path.view());
  m << (node < 0 ? "the inner graph `" : "the component `") << Path.view() << "`";
  if constexpr (node >= 0) m << " (" << type_name<typename node_types<Graph, node>::component>() << ")";
  m << " of " << graph_facts<Graph>::value.name;
}
template <class Graph, fixed_string Path>
struct node_without_parameters {
  static constexpr void tell(text& m) {
    m << "cca::controller::set: ";
    tell_node_at<Graph, Path>(m);
    m << " has no `parameters` that could be set: name a component that has"
      << (node_at<Graph>(Path.view()) < 0 ? ", as in `inner.component`" : ", or give it some");
  }
};
// Of a part that is to stop, or to start.
template <class Graph, fixed_string Path>
struct never_stopped_alone {
  static constexpr void tell(text& m) {
    m << "strategy.not_stoppable: ";
    tell_node_at<Graph, Path>(m);
    m << " can not be stopped on its own: write "
      << (node_at<Graph>(Path.view()) < 0 ? "`cca::stoppable<>` behind the graph in its node"
                                          : "`cca::stoppable<...>` around its strategy in its node");
  }
};
// Whether there are parameters at a known path; if not, the compiler prints the sentence. It is asked in the
// body of a function: among the arguments of a template, the compiler would tell it at length.
template <class Graph, fixed_string Path>
constexpr bool has_parameters() {
  static_assert(holds_or_tells<(can_set<Graph, Path>() || !has_path<Graph>(hash(Path.view()))),
                               node_without_parameters<Graph, Path>>::value);
  return can_set<Graph, Path>();
}
// Their type. Where there are none it takes anything, so that there is one error.
template <class Graph, fixed_string Path>
struct parameters_at {
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
