// A closed set of architectures for one robot. Each is checked at compile time, and one is active.
//
//   struct legs : cca::modes<cca::mode<"trot", trot<Robot>>, cca::mode<"stand", stand<Robot>>> {};
//
//   cca::controller<legs> c;   // begins in the first mode
//   c.switch_to<"stand">();    // between two beats
//
// A node of the same path and type in two modes is one component: it keeps its state at a switch.
// Errors: modes.*. Example: docs/modes.md.
#pragma once

#include <cca/component/component.hpp>
#include <cca/graph/items/graph.hpp>

namespace cca {

template <fixed_string Name, class Graph>
struct mode {};

template <class... Items>
struct modes {
  using cca_modes = detail::list<Items...>;
};

template <class Type> concept Modes = requires { typename Type::cca_modes; };

namespace detail {

template <Modes M>
inline constexpr no_component no_component_of<M>{
    " is a set of modes, which is no node: a mode holds the whole architecture, so put the other nodes of ",
    " into its modes, and give the set to a controller or a deployment"};

}  // namespace detail

}  // namespace cca
