// One beat of a graph: every function's turn, in order, with the samples of the beat as locals.
#pragma once

#include <cca/runtime/turn.hpp>

namespace cca::detail {

template <class Graph, class Order>
struct loop;
template <class Graph, int... Rank>
struct loop<Graph, std::integer_sequence<int, Rank...>> {
  template <int Turn>
  CCA_GLUE static void turn_unless_faulted(memory<Graph>& m, locals<Graph>& l, course& c, std::int64_t k) {
    if constexpr (counts_of<Graph>.may_fault)
      if (c.fault) return;
    take_turn<Graph, Turn>(m, l, c, k);
  }
  CCA_GLUE static void beat([[maybe_unused]] memory<Graph>& m, [[maybe_unused]] course& c, [[maybe_unused]] std::int64_t k) {
    [[maybe_unused]] locals<Graph> l;
    const int turns[] = {0, (turn_unless_faulted<plan_of<Graph>.order[Rank]>(m, l, c, k), 0)...};
    (void)turns;
  }
};

}  // namespace cca::detail
