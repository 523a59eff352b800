#pragma once
// An architecture like another one, but for some of its items.
//
//   struct distant : deployed::with_items<near, cca::wire<"robot.angles", "gait.angles", cca::delayed<1>>>
//   {};
//
// A node takes the place of the node of its name, a wire that of the wire to its input. An item that replaces
// nothing is added at the end. So only the differences are written down, and the rest stays the same type.
// Cost: nothing in the loop; one comparison for each pair of items when it is compiled.
#include <string_view>
#include <type_traits>

#include <cca/robots/items.hpp>

namespace deployed {

namespace detail {

using cca::detail::list;

// What an item is about: the name of a node, or the input that a wire feeds. Empty: neither.
template <class Item>
inline constexpr std::string_view place_of = {};
template <cca::fixed_string Name, class Component, class Strategy>
inline constexpr std::string_view place_of<cca::node<Name, Component, Strategy>> = Name.view();
template <cca::fixed_string From, cca::fixed_string To, class... Options>
inline constexpr std::string_view place_of<cca::wire<From, To, Options...>> = To.view();

template <class One, class Other>
inline constexpr bool replaces = !place_of<One>.empty() && place_of<One> == place_of<Other>;

template <class Item, class... Given>
struct changed {
  using type = Item;
};
template <class Item, class First, class... Rest>
struct changed<Item, First, Rest...>
    : std::conditional_t<replaces<First, Item>, std::type_identity<First>, changed<Item, Rest...>> {};

// The items of both lists, without those that replace one.
template <class Items, class Given>
struct joined;
template <class... Items, class... Given>
struct joined<list<Items...>, list<Given...>> {
  template <class One>
  using if_new = std::conditional_t<(replaces<One, Items> || ...), list<>, list<One>>;
  using type = cca::robots::graph_of<list<typename changed<Items, Given...>::type...>, if_new<Given>...>;
};

}  // namespace detail

template <class Graph, class... Items>
using with_items = typename detail::joined<typename Graph::cca_items, detail::list<Items...>>::type;

}  // namespace deployed
