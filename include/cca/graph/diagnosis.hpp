// The first broken rule of a graph, as a constexpr value.
//
//   static_assert(cca::well_formed<trot<cca::sim::oncilla>>);
//   static_assert(cca::diagnosis<broken>.rule == "space.mismatch");
#pragma once

#include <string_view>

#include <cca/graph/types.hpp>

namespace cca {

struct diagnosis_value {
  std::string_view rule;     // id of the rule; empty for a sound graph
  std::string_view where;    // the wire, node or port
  std::string_view message;  // what, where, why and what to do
};

namespace detail {

template <class Graph>
inline constexpr rule broken_rule_of = counts_of<Graph>.found.broken;

}  // namespace detail

template <class Graph>
inline constexpr bool well_formed = detail::broken_rule_of<Graph> == detail::rule::none;

template <class Graph>
inline constexpr diagnosis_value diagnosis = {detail::rule_ids[static_cast<std::size_t>(detail::broken_rule_of<Graph>)], {}, {}};

}  // namespace cca
