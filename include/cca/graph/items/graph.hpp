// An architecture: nodes, wires, and what it shows outside. A graph is a named struct,
//
//   struct trot : cca::graph<cca::rate<1000>,
//                            cca::node<"cpg", hopf>,
//                            cca::node<"gait", gait_shape>,
//                            cca::wire<"cpg.phase", "gait.phase">> {};
//
// and a graph is a component: it can be a node of another one, with the ports that it exposes.
#pragma once

#include <array>
#include <cstdint>

#include <cca/component/component.hpp>
#include <cca/component/strategies.hpp>
#include <cca/base/fixed_string.hpp>
#include <cca/space/space.hpp>

namespace cca {

namespace detail {

// An item that stands for several, and for other ends of wires: graph/items/test_input.hpp.
template <class Item>
inline constexpr bool is_test_input = false;
template <bool HasTestInputs, class... Items>
struct items_of_graph {
  using type = list<Items...>;
};

}  // namespace detail

template <class... Items>
struct graph {
  using cca_items =
      typename detail::items_of_graph<detail::is_any<detail::is_test_input<Items>...>, Items...>::type;
};

// A component, or a graph, under a name.
template <fixed_string Name, class Component, class Strategy = detail::by_default>
struct node {};

// From an output to an input. Options: a policy, and an `initial`. A `delayed` may stand beside a `queue` or
// a `merged`: the sample enters the queue when it arrives.
template <fixed_string From, fixed_string To, class... Options>
struct wire {};

// Shows a port of a node outside of the graph, under another name.
template <fixed_string Inner, fixed_string Outer>
struct expose {};

// Policies of a wire.
struct latest {};  // the newest sample published so far, this beat included

// A sample published in beat j arrives when beat j + Beats begins.
template <int Beats>
struct delayed {};

struct drop_oldest {};  // on a full queue the oldest waiting sample makes place
struct drop_newest {};  // on a full queue the arriving sample is lost
struct reject {};       // a full queue is a mistake: refused if the clocks prove it, else a fault

template <int Capacity, class Full = drop_oldest>
struct queue {};

// Several wires may end at one input if each of them is `merged` with the same numbers: one queue takes what
// they bring, in the order of arrival, and of one beat in the order in which it was published.
template <int Capacity, class Full = drop_oldest>
struct merged {};

// What the input holds until a first sample has come: a number for each coordinate, or one for all.
template <auto... Coordinates>
struct initial {};

// Refuses a graph in which a sample of the first port can be older than the bound when the second port is
// read.
template <class Property, class Bound>
struct require {};
template <fixed_string From, fixed_string To>
struct latency {};
template <int Count>
struct beats {};

template <class Type> concept Graph = requires { typename Type::cca_items; };

namespace detail {

// Whose option sets the policies of the wires in a graph (graph/items/inner_wires.hpp): none, its own, or
// that of the skeleton around it.
enum class wires_of : std::uint8_t { nobody, this_one, the_one_around };

}  // namespace detail
}  // namespace cca
