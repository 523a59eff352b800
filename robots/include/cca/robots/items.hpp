// Graphs put together from lists of items, for robots whose nodes and wires are generated.
//
//   struct my_robot : cca::robots::graph_of<cca::robots::items<cca::rate<1000>, cca::node<"bus", bus>>,
//                                           nodes_of_joints> {};
//
// Name it by a struct of your own: messages then show that name, and symbols stay short.
#pragma once

#include <cca/graph/items/graph.hpp>

namespace cca::robots {

template <class... Items>
using items = cca::detail::list<Items...>;

namespace detail {

template <class... Lists>
struct joined;
template <class... Items>
struct joined<items<Items...>> {
  using type = cca::graph<Items...>;
};
template <class... First, class... Second, class... Rest>
struct joined<items<First...>, items<Second...>, Rest...> : joined<items<First..., Second...>, Rest...> {};

}  // namespace detail

// The graph of all items of the lists, in their order.
template <class... Lists>
using graph_of = typename detail::joined<Lists...>::type;

}  // namespace cca::robots
