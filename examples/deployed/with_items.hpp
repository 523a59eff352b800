#pragma once
// An architecture like another one, but for some of its items.
//
//   struct distant : deployed::with_items<near, cca::wire<"robot.angles", "gait.angles", cca::delayed<1>>>
//   {};
//
// A node takes the place of the node of its name, a wire that of the wire to its input. An item that replaces
// nothing is added at the end. So only the differences are written down, and the rest stays the same type.
// Cost: nothing in the loop; one comparison for each pair of items when it is compiled.
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <utility>

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

// The number of the item that replaces this one, or -1.
template <class Item, class... Given>
constexpr int replacement_of() {
  int found = -1, i = 0;
  (void)((replaces<Given, Item> ? (found = i, true) : (++i, false)) || ...);
  return found;
}
template <int I, class Item>
struct numbered {
  using type = Item;
};
template <class Given, class Numbers = void>
struct numbered_items;
template <class... Given>
struct numbered_items<list<Given...>> : numbered_items<list<Given...>, std::index_sequence_for<Given...>> {};
template <class... Given, std::size_t... I>
struct numbered_items<list<Given...>, std::index_sequence<I...>> : numbered<static_cast<int>(I), Given>... {};
template <int I, class Item>
numbered<I, Item> item_at(const numbered<I, Item>&);

template <class Item, int Replacement, class Given>
struct changed_to {
  using type = typename decltype(item_at<Replacement>(std::declval<numbered_items<Given>>()))::type;
};
template <class Item, class Given>
struct changed_to<Item, -1, Given> {
  using type = Item;
};
template <class Item, class... Given>
using changed = typename changed_to<Item, replacement_of<Item, Given...>(), list<Given...>>::type;

// The items of both lists, without those that replace one.
template <class Items, class Given>
struct joined;
template <class... Items, class... Given>
struct joined<list<Items...>, list<Given...>> {
  template <class One>
  using if_new = std::conditional_t<(replaces<One, Items> || ...), list<>, list<One>>;
  using type = cca::robots::graph_of<list<changed<Items, Given...>...>, if_new<Given>...>;
};

}  // namespace detail

template <class Graph, class... Items>
using with_items = typename detail::joined<typename Graph::cca_items, detail::list<Items...>>::type;

}  // namespace deployed
