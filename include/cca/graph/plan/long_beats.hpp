// A beat of very many calls is compiled in parts: the optimisers of both compilers take time that grows with
// the square of a function's length. What goes from one part to a later one lies in memory, all else may stay
// in registers.
//
// Cost at run time: a call for each part, and a store and a load for each sample that crosses from one to
// another. A graph of up to `most_in_one` calls is one loop and pays nothing.
#pragma once

#include <cca/graph/plan/flat.hpp>

namespace cca::detail {

inline constexpr int most_in_one = 128;

// A test of the parts themselves cuts smaller graphs by a specialisation.
template <class Graph>
inline constexpr int calls_in_part = graph_facts<Graph>::value.sizes.calls <= most_in_one ? most_in_one : 64;

constexpr bool in_one_part(const flat_view& g, int call, int other) {
  return g.calls[call].rank / g.calls_in_part == g.calls[other].rank / g.calls_in_part;
}

}  // namespace cca::detail
