// From numbers back to types: the component and the strategy of each node.
#pragma once

#include <array>
#include <utility>

#include <cca/base/compiler.hpp>
#include <cca/graph/layout/layout.hpp>

namespace cca::detail {

template <class Type>
struct box {
  using type = Type;
};

// Item I of a graph. Keyed on the graph, not on the list of its items, which is long.
template <class Graph, int I, bool Directly = has_nth_type>
struct nth_item {
  using type = typename nth_type<typename Graph::cca_items>::template at<I>;
};

// Where the compiler can't find it directly (base/compiler.hpp): a tree of blocks of sixteen, built once a
// graph, searched by overload resolution within a block. `pick` is called by its full name on a pointer: to
// look it up by argument would complete every item's type.
template <int I, class Type>
struct indexed {};
template <class Indices, class... Types>
struct block_of;
template <int... I, class... Types>
struct block_of<std::integer_sequence<int, I...>, Types...> : indexed<I, Types>... {};
template <class... Types>
using block = block_of<std::make_integer_sequence<int, sizeof...(Types)>, Types...>;
template <int I, class Type>
box<Type> pick(const indexed<I, Type>*);

template <class Done, class... Types>
struct blocks_of;
template <class... Done,
          class T0,
          class T1,
          class T2,
          class T3,
          class T4,
          class T5,
          class T6,
          class T7,
          class T8,
          class T9,
          class T10,
          class T11,
          class T12,
          class T13,
          class T14,
          class T15,
          class... Rest>
struct blocks_of<list<Done...>, T0, T1, T2, T3, T4, T5, T6, T7, T8, T9, T10, T11, T12, T13, T14, T15, Rest...>
    : blocks_of<list<Done..., block<T0, T1, T2, T3, T4, T5, T6, T7, T8, T9, T10, T11, T12, T13, T14, T15>>,
                Rest...> {};
template <class... Done, class... Rest>
struct blocks_of<list<Done...>, Rest...> {
  using type = list<Done..., block<Rest...>>;
};

// The items, then blocks of them, then blocks of blocks, up to at most sixteen.
template <class List>
struct blocked;
template <class... Types>
struct blocked<list<Types...>> : blocks_of<list<>, Types...> {};
template <class Graph, int Level>
struct level_of {
  using type = typename blocked<typename level_of<Graph, Level - 1>::type>::type;
};
template <class Graph>
struct level_of<Graph, 0> {
  using type = typename Graph::cca_items;
};
template <class List>
struct as_block;
template <class... Types>
struct as_block<list<Types...>> {
  using type = block<Types...>;
};

template <class Graph, int Level, int I, bool IsTop>
struct entry;
template <class Graph, int Level, int I>
inline constexpr bool is_top = graph_facts<Graph>::value.count <= 16 << 4 * Level;
template <class Graph, int Level, int I>
struct entry<Graph, Level, I, true>
    : decltype(detail::pick<I>(
          static_cast<typename as_block<typename level_of<Graph, Level>::type>::type*>(nullptr))) {};
template <class Graph, int Level, int I>
struct entry<Graph, Level, I, false>
    : decltype(detail::pick<I % 16>(
          static_cast<typename entry<Graph, Level + 1, I / 16, is_top<Graph, Level + 1, I / 16>>::type*>(
              nullptr))) {};

template <class Graph, int I>
struct nth_item<Graph, I, false> : entry<Graph, 0, I, is_top<Graph, 0, I>> {};

// Where a node stands among the items of a graph: the item, and its number within that item's own graph.
struct node_place {
  int item = 0, inner = 0;
};

template <class Graph>
inline constexpr auto node_places = [] {
  std::array<node_place, static_cast<std::size_t>(graph_size<Graph>.nodes) + 1> places{};
  std::size_t n = 0;
  const auto& graph = graph_facts<Graph>::value;
  for (int i = 0; i < graph.count; ++i) {
    const auto& item = graph.items[i];
    const int nodes = item.kind == item_kind::node    ? 1
                      : item.kind == item_kind::graph ? item.inner->sizes.nodes
                                                      : 0;
    for (int inner = 0; inner < nodes; ++inner) places[n++] = {i, inner};
  }
  return places;
}();

template <class Node, int Inner>
struct node_type;

template <class Graph, int Node>
struct node_types : node_type<typename nth_item<Graph, node_places<Graph>[Node].item>::type,
                              node_places<Graph>[Node].inner> {};

template <fixed_string Name, class Component, class Strategy, int Inner>
struct node_type<node<Name, Component, Strategy>, Inner> {
  using component = Component;
  using strategy = Strategy;
};
template <fixed_string Name, Graph Inner, class Strategy, int Node>
struct node_type<node<Name, Inner, Strategy>, Node> : node_types<Inner, Node> {};

// The default strategy filled in.
template <class Strategy, bool HasInputs>
struct strategy_or_default {
  using type = Strategy;
};
template <class Strategy, bool HasInputs>
struct strategy_or_default<stoppable<Strategy>, HasInputs> : strategy_or_default<Strategy, HasInputs> {};
template <>
struct strategy_or_default<by_default, true> {
  using type = restless;
};
template <>
struct strategy_or_default<by_default, false> {
  using type = timed<1>;
};

// The numbers below `Count` that are chosen by a predicate, a type with a constexpr static call, as a
// sequence.
template <int Count, class Predicate>
inline constexpr auto chosen_numbers = [] {
  std::pair<std::array<int, static_cast<std::size_t>(Count) + 1>, int> result{};
  for (int i = 0; i < Count; ++i)
    if (Predicate::holds(static_cast<std::size_t>(i)))
      result.first[static_cast<std::size_t>(result.second++)] = i;
  return result;
}();

template <int Count, class Predicate, int... I>
auto chosen_sequence(std::integer_sequence<int, I...>)
    -> std::integer_sequence<int, chosen_numbers<Count, Predicate>.first[I]...>;

template <int Count, class Predicate>
using chosen = decltype(chosen_sequence<Count, Predicate>(
    std::make_integer_sequence<int, chosen_numbers<Count, Predicate>.second>{}));

}  // namespace cca::detail
