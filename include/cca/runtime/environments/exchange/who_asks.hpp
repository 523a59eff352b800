// Which environments ask for parts and modes, which are asked, and what of that leaves an environment.
#pragma once

#include <utility>

#include <cca/graph/deployment/deployed_modes.hpp>
#include <cca/runtime/stoppable_parts.hpp>

namespace cca::detail {

// Whether an environment has a node of a part, and whether its components stop or start one.
template <class D, int E>
constexpr bool has_part(int number) {
  for (int n = 0; n < counts_of<D>.node_count; ++n)
    if (plan_of<D>.nodes[array_size(n)].place == E && is_in_part<D>(n, number)) return true;
  return false;
}
// All nodes of a part are in this environment.
template <class D>
constexpr bool is_part_of(int number, int environment) {
  for (int n = 0; n < counts_of<D>.node_count; ++n)
    if (is_in_part<D>(n, number) && plan_of<D>.nodes[array_size(n)].place != environment) return false;
  return true;
}
template <class D>
constexpr bool asks_for_part(int environment, int number) {
  for (int r = 0; r < counts_of<D>.request_count; ++r) {
    const auto& request = plan_of<D>.requests[array_size(r)];
    const int node = plan_of<D>.calls[array_size(request.call)].node;
    if (request.part == number && plan_of<D>.nodes[array_size(node)].place == environment) return true;
  }
  return false;
}
template <DeploymentOfModes D>
constexpr bool asks_for_part(int environment, int number) {
  bool asks = false;
  for_each_deployed_mode<D>([&]<class Mode>() {
    for (int p = 0; p < counts_of<Mode>.part_count; ++p)
      if (sharing::find_part(shown_plan<Mode>, p, shown_plan<D>) == number)
        asks |= asks_for_part<Mode>(environment, p);
  });
  return asks;
}
// Any component.
template <class D>
constexpr bool is_asked_for(int part) {
  for (int e = 0; e < environment_count<D>; ++e)
    if (asks_for_part<D>(e, part)) return true;
  return false;
}
// Whether a component of it, in any mode, may ask for a mode.
template <class D>
constexpr bool asks_for_modes(int) {
  return false;
}
template <DeploymentOfModes D>
constexpr bool asks_for_modes(int environment) {
  for (int c = 0; c < counts_of<D>.call_count; ++c)
    if (const auto& one = plan_of<D>.calls[array_size(c)];
        one.function->requested_count > 0 && plan_of<D>.nodes[array_size(one.node)].place == environment)
      return true;
  return false;
}
template <class D>
constexpr bool asks_for_parts(int environment) {
  for (int p = 0; p < counts_of<D>.part_count; ++p)
    if (asks_for_part<D>(environment, p)) return true;
  return false;
}
template <class D>
constexpr bool asks_for_changes(int environment) {
  return asks_for_parts<D>(environment) || asks_for_modes<D>(environment);
}
// What components of one environment ask for, of parts in another: it takes a beat, like a sample.
template <class D, int To>
constexpr bool is_asked_by(int from) {
  for (int p = 0; p < counts_of<D>.part_count; ++p)
    if (has_part<D, To>(p) && asks_for_part<D>(from, p)) return true;
  return asks_for_modes<D>(from);
}

// A part that has nodes in several environments. From outside it is asked for by an order, which has effect
// in all of them in one beat. So are modes, and a part that another process runs or components ask for.
template <class D>
constexpr bool is_spread_part(int number) {
  int first = -1;
  for (int n = 0; n < counts_of<D>.node_count; ++n)
    if (is_in_part<D>(n, number)) {
      const int environment = plan_of<D>.nodes[array_size(n)].place;
      if (first >= 0 && environment != first) return true;
      first = environment;
    }
  return false;
}
template <class D>
inline constexpr bool has_orders =
    DeploymentOfModes<D> || (counts_of<D>.part_count > 0 && environment_count<D> > 1);
// The environments that obey them.
template <class D, int E>
inline constexpr bool obeys_orders = [] {
  for (int p = 0; p < counts_of<D>.part_count; ++p)
    if (has_orders<D> && has_part<D, E>(p)) return true;
  return DeploymentOfModes<D>;
}();

// These requests leave as samples do, after the outputs: number `output_count + E` has those of environment
// E. A coordinate for each part: its call's place in the order of a beat, from 1; below 0: to stop; 0:
// nothing. Of a set of modes two more: the place of the call that asks for a mode, and its number.
template <class D>
constexpr bool is_request(int leaving) {
  return leaving >= counts_of<D>.output_count;
}
// The orders come after them: what is asked for from outside, as its kind and the number of the part or mode.
template <class D>
constexpr bool is_order(int leaving) {
  return leaving >= counts_of<D>.output_count + environment_count<D>;
}
template <class D, int E>
inline constexpr int orders_of = counts_of<D>.output_count + environment_count<D> + E;
template <class D>
inline constexpr int size_of_request = counts_of<D>.part_count + (DeploymentOfModes<D> ? 2 : 0);
template <class D, int Leaving>
inline constexpr int size_of_leaving = [] {
  if constexpr (is_order<D>(Leaving)) return 2;
  else if constexpr (is_request<D>(Leaving)) return size_of_request<D>;
  else return size_of_output<D, Leaving>;
}();

}  // namespace cca::detail
