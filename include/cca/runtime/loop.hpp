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
    const int turns[] = {0, (take_turn<Graph, plan_of<Graph>.order[Rank]>(m, l, c, k), 0)...};
    (void)turns;
  }
};

}  // namespace cca::detail
