// The policies of the wires inside a skeleton, as the last argument of the skeleton:
//
//   cca::farm<worker, whole, result, cca::inner_wires<cca::delayed<1>>>
//   cca::adaptive_component<module, criterion, cca::inner_wires<cca::delayed<1>>>
//
// With a delay its nodes may be placed in environments of their own: `cca::nodes<"ik.worker0">`. Without this
// option the wires are as the skeleton says. All inner wires get the same policies; for others, wire the
// nodes by hand. A wrong policy is refused as on any wire (wire.bad_option).
//
// A skeleton of one's own takes it by `wire_inside` and states `inner_wires_of = wires_of::this_one`, so that
// deployment.undelayed says what to write. Cost: that of the policies. Example:
// tests/runtime/deployment/skeletons.cpp; docs/skeletons.md.
#pragma once

#include <type_traits>

#include <cca/graph/items/graph.hpp>

namespace cca {

template <class... Policies>
struct inner_wires {};

namespace detail {

template <class Option>
constexpr bool is_inner_wires = false;
template <class... Policies>
constexpr bool is_inner_wires<inner_wires<Policies...>> = true;

// The policies that the options state, as a list; else the default.
template <class Default, class... Options>
struct inner_policies {
  using type = Default;
};
template <class Default, class... Policies, class... Rest>
struct inner_policies<Default, inner_wires<Policies...>, Rest...> {
  using type = list<Policies...>;
};
template <class Default, class First, class... Rest>
struct inner_policies<Default, First, Rest...> : inner_policies<Default, Rest...> {};

// A wire with the policies of a list.
template <fixed_string From, fixed_string To, class Policies>
struct wire_with_policies;
template <fixed_string From, fixed_string To, class... Policies>
struct wire_with_policies<From, To, list<Policies...>> {
  using type = wire<From, To, Policies...>;
};
template <fixed_string From, fixed_string To, class Policies>
using wire_inside = typename wire_with_policies<From, To, Policies>::type;

}  // namespace detail
}  // namespace cca
