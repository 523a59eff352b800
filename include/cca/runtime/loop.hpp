// One beat of a graph: every function's call, in order, with the samples of the beat as locals.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <new>
#include <type_traits>
#include <utility>

#include <cca/graph/parts.hpp>
#include <cca/runtime/call.hpp>

namespace cca::detail {

// The local that an input is the last to read.
template <class Graph, int Input>
CCA_GLUE auto& last_read([[maybe_unused]] locals<Graph>& l, [[maybe_unused]] int slot) {
  if constexpr (input_of<Graph, Input>.is_last)
    return part_of<storage<Graph, layout_of<Graph>.sources[Input].group>>(l).all[slot];
  else return l;
}
template <class Graph>
CCA_GLUE void end(locals<Graph>&) {}
template <int Size>
CCA_GLUE void end(sure_sample<Size>& sample) {
  ::new (static_cast<void*>(&sample)) sure_sample<Size>;
}

// A function of a long beat on g++, for all that are alike: put together once, then inlined wherever it is
// alike. Where its locals lie is found first: afterwards g++ would no longer see that they lie where the
// function read them.
template <class Graph,
          int Call,
          class LikeInputs = inputs_like<Graph, Call>,
          class Positions = input_positions<Graph, Call>>
struct in_one;
template <class Graph, int Call, int... Input, int... Position>
struct in_one<Graph, Call, std::integer_sequence<int, Input...>, std::integer_sequence<int, Position...>> {
  CCA_ONE static void take_turn(
      memory<Graph>& m, locals<Graph>& l, beat_outcome& c, std::int64_t k, const call_place& of) {
    take_and_end(m, l, c, k, of,
                 last_read<Graph, Input>(l, layout_of<Graph>.sources[of.first_input + Position].slot)...);
  }

private:
  template <class... Samples>
  CCA_GLUE static void take_and_end(memory<Graph>& m,
                                    locals<Graph>& l,
                                    beat_outcome& c,
                                    std::int64_t k,
                                    const call_place& of,
                                    Samples&... read) {
    function_like<Graph, Call>::take_turn(m, l, c, k, of);
    (end(read), ...);
  }
};

// The function whose call comes at this rank, and where it reads and writes.
template <class Graph, int Like>
using one_function =
    std::conditional_t<simplified_once<Graph>, in_one<Graph, Like>, function_like<Graph, Like>>;
template <class Graph, int Rank>
using function_at = one_function<Graph, layout_of<Graph>.like[plan_of<Graph>.order[Rank]]>;
template <class Graph, int Rank>
inline constexpr const call_place& place_at = layout_of<Graph>.calls[plan_of<Graph>.order[Rank]];

// Clang learns which function it is only while it inlines: by then it has simplified it, once for all that
// are alike.
template <class Graph>
inline void call_turn(
    void (*take_turn)(memory<Graph>&, locals<Graph>&, beat_outcome&, std::int64_t, const call_place&),
    memory<Graph>& m,
    locals<Graph>& l,
    beat_outcome& c,
    std::int64_t k,
    const call_place& of) {
  take_turn(m, l, c, k, of);
}

template <class Graph, int Rank>
CCA_GLUE void take_turn(memory<Graph>& m, locals<Graph>& l, beat_outcome& c, std::int64_t k) {
  if constexpr (inlines_through)
    call_turn<Graph>(function_at<Graph, Rank>::take_turn, m, l, c, k, place_at<Graph, Rank>);
  else function_at<Graph, Rank>::take_turn(m, l, c, k, place_at<Graph, Rank>);
  if constexpr (is_long_beat<Graph> && Rank % calls_between_fences == calls_between_fences - 1)
    std::atomic_signal_fence(std::memory_order_seq_cst);
}

// A fault is rare: were it not said, g++ would take what lies behind a few of these questions for cold, and
// optimise it for size.
CCA_GLUE bool goes_on(const beat_outcome& c) {
  if (c.fault) [[unlikely]]
    return false;
  return true;
}

// The functions from rank `First` on, until one faults. Where a beat can end early it is one chain, so that
// g++ sees that no later call reads what an earlier one did not write.
template <class Graph, int First, int... Rank>
CCA_GLUE void take_turns(memory<Graph>& m,
                         locals<Graph>& l,
                         beat_outcome& c,
                         std::int64_t k,
                         std::integer_sequence<int, Rank...>) {
  if constexpr (counts_of<Graph>.may_fault)
    (void)((take_turn<Graph, First + Rank>(m, l, c, k), goes_on(c)) && ...);
  else (take_turn<Graph, First + Rank>(m, l, c, k), ...);
}

template <class Graph, int First, int Count>
struct part_of_beat {
  CCA_GLUE static void take(memory<Graph>& m, beat_outcome& c, std::int64_t k) {
    [[maybe_unused]] locals<Graph> l;
    take_turns<Graph, First>(m, l, c, k, std::make_integer_sequence<int, Count>{});
  }
  // A function of its own, where there are too many for one.
  [[gnu::noinline, gnu::flatten]] static void take_apart(memory<Graph>& m,
                                                         beat_outcome& c,
                                                         std::int64_t k) noexcept {
    take(m, c, k);
  }
};

template <class Graph, int First>
using part_from =
    part_of_beat<Graph, First, std::min(calls_in_part<Graph>, counts_of<Graph>.call_count - First)>;

template <class Graph, int... Part>
CCA_GLUE void take_parts(memory<Graph>& m,
                         beat_outcome& c,
                         std::int64_t k,
                         std::integer_sequence<int, Part...>) {
  (void)((part_from<Graph, Part * calls_in_part<Graph>>::take_apart(m, c, k), goes_on(c)) && ...);
}

template <class Graph>
CCA_GLUE void take_beat(memory<Graph>& m, beat_outcome& c, std::int64_t k) {
  constexpr int parts = (counts_of<Graph>.call_count + calls_in_part<Graph> - 1) / calls_in_part<Graph>;
  if constexpr (parts <= 1) part_from<Graph, 0>::take(m, c, k);
  else take_parts(m, c, k, std::make_integer_sequence<int, parts>{});
}

}  // namespace cca::detail
