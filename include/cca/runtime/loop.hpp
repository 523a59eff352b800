// One beat of a graph: every function's turn, in order, with the samples of the beat as locals.
#pragma once

#include <cca/graph/parts.hpp>
#include <cca/runtime/turn.hpp>

namespace cca::detail {

template <class Graph, int Rank>
using function_at = function_like<Graph, layout_of<Graph>.like[plan_of<Graph>.order[Rank]]>;

template <class Graph, int Rank>
CCA_GLUE void take_turn(memory<Graph>& m, locals<Graph>& l, course& c, std::int64_t k) {
  function_at<Graph, Rank>::take_turn(m, l, c, k, layout_of<Graph>.turns[plan_of<Graph>.order[Rank]]);
}

// The functions from rank `First` on.
template <class Graph, int First, class Ranks>
struct part_of_beat;
template <class Graph, int First, int... Rank>
struct part_of_beat<Graph, First, std::integer_sequence<int, Rank...>> {
  CCA_GLUE static void take([[maybe_unused]] memory<Graph>& m, [[maybe_unused]] course& c, [[maybe_unused]] std::int64_t k) {
    [[maybe_unused]] locals<Graph> l;
    // Where a beat can end early it is one chain, so that g++ sees that no later turn reads what an earlier one did not write.
    if constexpr (counts_of<Graph>.may_fault) {
      (void)((take_turn<Graph, First + Rank>(m, l, c, k), !c.fault) && ...);
    } else {
      const int turns[] = {0, (take_turn<Graph, First + Rank>(m, l, c, k), 0)...};
      (void)turns;
    }
  }
  // A function of its own, where there are too many for one.
  [[gnu::noinline, gnu::flatten]] static void take_apart(memory<Graph>& m, course& c, std::int64_t k) { take(m, c, k); }
};

template <class Graph, int First, int Left = counts_of<Graph>.turn_count - First>
using part_from = part_of_beat<Graph, First, std::make_integer_sequence<int, (Left < turns_in_part<Graph> ? Left : turns_in_part<Graph>)>>;

template <class Graph, int... Part>
CCA_GLUE void take_parts(memory<Graph>& m, course& c, std::int64_t k, std::integer_sequence<int, Part...>) {
  (void)((part_from<Graph, Part * turns_in_part<Graph>>::take_apart(m, c, k), !c.fault) && ...);
}

template <class Graph>
CCA_GLUE void take_beat(memory<Graph>& m, course& c, std::int64_t k) {
  constexpr int parts = (counts_of<Graph>.turn_count + turns_in_part<Graph> - 1) / turns_in_part<Graph>;
  if constexpr (parts <= 1) part_from<Graph, 0>::take(m, c, k);
  else take_parts(m, c, k, std::make_integer_sequence<int, parts>{});
}

}  // namespace cca::detail
