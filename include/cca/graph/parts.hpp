// A beat of very many functions is compiled in parts: the optimisers of both compilers take time that grows
// with the square of a function's length. What goes from one part to a later one lies in memory, all else
// stays in registers.
//
// Cost, at run time: a call a part, and a store and a load for each sample that crosses. A graph of up to
// `most_in_one` functions is one loop and pays nothing.
#pragma once

#include <cca/base/inlining.hpp>
#include <cca/graph/plan/flat.hpp>

namespace cca::detail {

inline constexpr int most_in_one = 128;

// A test of the parts themselves cuts smaller graphs by a specialisation.
template <class Graph>
inline constexpr int calls_in_part = graph_facts<Graph>::value.sizes.calls <= most_in_one ? most_in_one : 64;

template <class Graph>
inline constexpr bool is_long_beat = graph_facts<Graph>::value.sizes.calls > 64;

// In a long beat a fence for the compiler alone, which is no instruction, comes after so many functions. A
// read from memory is looked for among the writes before it, back to the last fence; to the beginning of the
// beat that was a sixth of g++'s time above Eigen at 100 nodes. A short beat has none: with eight drives,
// large components and few, it took g++ 8 % more instructions.
inline constexpr int calls_between_fences = 16;

// In a long beat g++ simplifies a function once for all that are alike and inlines it then, in a sixth less
// time. In a short one it inlines first, which nodes fewer instructions: the trot at -O3 would take 2 %
// more.
//
// A local then ends with the function that reads it last: to see for itself that a store is dead, g++ would
// look through all that follows it, and give up after 256 questions.
template <class Graph>
inline constexpr bool simplified_once = is_long_beat<Graph> && !inlines_through;

constexpr bool in_one_part(const flat_view& g, int call, int other) {
  return g.calls[call].rank / g.calls_in_part == g.calls[other].rank / g.calls_in_part;
}

}  // namespace cca::detail
