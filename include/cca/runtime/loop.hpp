// One beat of a graph: every function's turn, in order, with the samples of the beat as locals.
#pragma once

#include <cca/runtime/turn.hpp>

namespace cca::detail {

template <class Graph, class Order>
struct loop;
template <class Graph, int... Rank>
struct loop<Graph, std::integer_sequence<int, Rank...>> {
  CCA_GLUE static void beat([[maybe_unused]] memory<Graph>& m, [[maybe_unused]] course& c, [[maybe_unused]] std::int64_t k) {
    [[maybe_unused]] locals<Graph> l;
    // Where a beat can end early it is one chain, so that g++ sees that no later turn reads what an earlier one did not write; clang
    // takes no longer one.
    if constexpr (counts_of<Graph>.may_fault && sizeof...(Rank) <= 250) {
      (void)((take_turn<Graph, plan_of<Graph>.order[Rank]>(m, l, c, k), !c.fault) && ...);
    } else {
      const int turns[] = {0, (take_turn<Graph, plan_of<Graph>.order[Rank]>(m, l, c, k), 0)...};
      (void)turns;
    }
  }
};

}  // namespace cca::detail
