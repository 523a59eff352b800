// Tools for lists of graph items (nodes, wires, exposed ports): make a graph from a list, make a path from
// two names.
#pragma once

#include <cca/graph/items/graph.hpp>

namespace cca::detail {

template <class List>
struct graph_from;
template <class... Items>
struct graph_from<list<Items...>> : graph<Items...> {};

// path_to<"module", "goal"> is "module.goal".
template <std::size_t A, std::size_t B>
consteval auto with_dot(const fixed_string<A>& node, const fixed_string<B>& port) {
  char text[A + B]{};
  for (std::size_t i = 0; i + 1 < A; ++i) text[i] = node.text[i];
  text[A - 1] = '.';
  for (std::size_t i = 0; i < B; ++i) text[A + i] = port.text[i];
  return fixed_string<A + B>(text);
}
template <fixed_string Node, fixed_string Port>
inline constexpr auto path_to = with_dot(Node, Port);

template <bool Chosen, class List>
using items_if = std::conditional_t<Chosen, List, list<>>;

}  // namespace cca::detail
