// One beat of a graph: every function's turn, in order, with the samples of the beat as locals.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <cca/graph/parts.hpp>
#include <cca/runtime/turn.hpp>

namespace cca::detail {

// In a long beat g++ simplifies a function once for all that are alike and inlines it then, in a sixth less time. In a short one it inlines
// first, which leaves fewer instructions: the trot at -O3 takes 0.996 of the loop by hand, and would take 1.015.
template <class Graph>
inline constexpr bool simplified_once = counts_of<Graph>.turn_count > 64 && !in_pieces;

template <class Graph, int Turn>
struct simplified {
  [[gnu::flatten]] static void take_turn(memory<Graph>& m, locals<Graph>& l, course& c, std::int64_t k, const turn_place& of) {
    function_like<Graph, Turn>::take_turn(m, l, c, k, of);
  }
};

template <class Graph, int Rank>
CCA_GLUE void take_turn(memory<Graph>& m, locals<Graph>& l, course& c, std::int64_t k) {
  constexpr int turn = plan_of<Graph>.order[Rank], like = layout_of<Graph>.like[turn];
  using function = std::conditional_t<simplified_once<Graph>, simplified<Graph, like>, function_like<Graph, like>>;
  function::take_turn(m, l, c, k, layout_of<Graph>.turns[turn]);
}

// The functions from rank `First` on, until one faults. Where a beat can end early it is one chain, so that g++ sees that no
// later turn reads what an earlier one did not write.
template <class Graph, int First, int... Rank>
CCA_GLUE void take_turns(memory<Graph>& m, locals<Graph>& l, course& c, std::int64_t k, std::integer_sequence<int, Rank...>) {
  if constexpr (counts_of<Graph>.may_fault) (void)((take_turn<Graph, First + Rank>(m, l, c, k), !c.fault) && ...);
  else (take_turn<Graph, First + Rank>(m, l, c, k), ...);
}

template <class Graph, int First, int Count>
CCA_PIECE void take_piece(memory<Graph>& m, locals<Graph>& l, course& c, std::int64_t k) {
  take_turns<Graph, First>(m, l, c, k, std::make_integer_sequence<int, Count>{});
}

// Nothing is asked in between where nothing can fault: clang would see too late that the answer is known. Where it is asked, clang
// is told that the beat goes on: what it takes for seldom it does not inline.
template <class Graph, int First, int Count, int Size, int... Piece>
CCA_GLUE void take_pieces(memory<Graph>& m, locals<Graph>& l, course& c, std::int64_t k, std::integer_sequence<int, Piece...>) {
  if constexpr (counts_of<Graph>.may_fault)
    (void)((take_piece<Graph, First + Piece * Size, std::min(Size, Count - Piece * Size)>(m, l, c, k), __builtin_expect(!c.fault, true)) && ...);
  else
    (take_piece<Graph, First + Piece * Size, std::min(Size, Count - Piece * Size)>(m, l, c, k), ...);
}

template <class Graph, int First, int Count>
struct part_of_beat {
  // Each turn is a piece; in a long beat eight are, since each piece costs the compiler's front end something.
  static constexpr int piece = turns_in_part<Graph> == most_in_one ? 1 : 8;

  CCA_GLUE static void take(memory<Graph>& m, course& c, std::int64_t k) {
    [[maybe_unused]] locals<Graph> l;
    if constexpr (in_pieces)
      take_pieces<Graph, First, Count, piece>(m, l, c, k, std::make_integer_sequence<int, (Count + piece - 1) / piece>{});
    else
      take_turns<Graph, First>(m, l, c, k, std::make_integer_sequence<int, Count>{});
  }
  // A function of its own, where there are too many for one.
  [[gnu::noinline, gnu::flatten]] static void take_apart(memory<Graph>& m, course& c, std::int64_t k) { take(m, c, k); }
};

template <class Graph, int First>
using part_from = part_of_beat<Graph, First, std::min(turns_in_part<Graph>, counts_of<Graph>.turn_count - First)>;

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
