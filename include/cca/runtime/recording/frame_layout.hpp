// A frame has all samples that a graph publishes in one beat, as words of eight bytes, with room for each
// output whether it is published or not:
//
//   0            the beat
//   1 + output   its time of origin; `never`: not published in this beat
//   at[output]   its coordinates
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include <cca/base/array_size.hpp>
#include <cca/base/inlining.hpp>
#include <cca/graph/layout/lookup.hpp>
#include <cca/space/origin.hpp>

namespace cca::detail {

template <int Outputs>
struct frame_layout {
  std::array<int, array_size(Outputs + 1)> at{};
  std::array<int, array_size(Outputs + 1)> size{};           // coordinates
  std::array<bool, array_size(Outputs + 1)> in_each_beat{};  // surely published
  int words = 0;
};

template <class Graph>
inline constexpr auto frame_layout_of = [] {
  constexpr int outputs = counts_of<Graph>.output_count;
  frame_layout<outputs> frame;
  const auto& plan = plan_of<Graph>;
  frame.words = 1 + outputs;
  for (std::size_t o = 0; o < array_size(outputs); ++o) {
    const auto& out = plan.outputs[o];
    const auto& call = plan.calls[array_size(out.call)];
    const auto& port = call.function->outputs[out.port];
    frame.in_each_beat[o] = published(port, call).every_beat() && !counts_of<Graph>.may_fault;
    frame.at[o] = frame.words;
    frame.size[o] = port.space->size;
    frame.words += frame.size[o];
  }
  frame.words = (frame.words + 7) / 8 * 8;  // whole lines of the cache
  return frame;
}();

// Outputs that are not surely published in each beat: their frames need a mark.
template <class Graph>
struct is_seldom {
  static constexpr bool holds(std::size_t o) { return !frame_layout_of<Graph>.in_each_beat[o]; }
};

// Marks outputs as not published. A list: a loop would not be unrolled, and a fold has at most 256 operands
// (docs/compilers.md).
template <class Outputs>
struct forget;
template <int... Output>
struct forget<std::integer_sequence<int, Output...>> {
  CCA_INLINE static void in(std::int64_t* frame) {
    const int all[] = {0, (frame[1 + Output] = never, 0)...};
    (void)all;
  }
};

}  // namespace cca::detail
