// A frame has all samples that one loop publishes in one beat, as words of eight bytes, with room for each
// output whether it is published or not:
//
//   0                the beat
//   origin[output]   its time of origin; `never`: not published in this beat
//   at[output]       its coordinates
//   earlier[output]  of a free-running environment, where queues take all that its cycles publish: how many
//                    arrived in this beat before this one, how many are missing, and the origins and
//                    coordinates of the first
//
// The loop of an environment has only the outputs of its own components; that of the first one also what has
// come from free-running environments. All modes of a set have the same
// frames, with the outputs of all of them (runtime/modes/shared_state.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <utility>

#include <cca/base/array_size.hpp>
#include <cca/base/inlining.hpp>
#include <cca/graph/layout/lookup.hpp>
#include <cca/graph/marks/recordable.hpp>
#include <cca/space/origin.hpp>

namespace cca::detail {

template <int Outputs>
struct frame_layout {
  std::array<int, array_size(Outputs + 1)> origin{};  // -1: published by another loop
  std::array<int, array_size(Outputs + 1)> at{};
  std::array<int, array_size(Outputs + 1)> size{};     // coordinates
  std::array<int, array_size(Outputs + 1)> earlier{};  // 0: none
  int origins = 0;                                     // in the words from 1 on
  int words = 0;
};

// Outputs of another loop that this one tells a recorder of.
template <class Graph>
struct told_for_others {
  static constexpr bool holds(std::size_t) { return false; }
};

// Of an output how many samples of one beat it may tell of before the newest.
template <class Graph>
struct told_earlier {
  static constexpr int most(std::size_t) { return 0; }
};

template <class Graph>
inline constexpr auto frame_layout_of = [] {
  constexpr int outputs = counts_of<Graph>.output_count;
  frame_layout<outputs> frame;
  const auto& plan = plan_of<Graph>;
  for (std::size_t o = 0; o < array_size(outputs); ++o)
    frame.origin[o] =
        plan.calls[array_size(plan.outputs[o].call)].elsewhere && !told_for_others<Graph>::holds(o)
            ? -1
            : ++frame.origins;
  frame.words = 1 + frame.origins;
  for (std::size_t o = 0; o < array_size(outputs); ++o) {
    const auto& out = plan.outputs[o];
    const auto& call = plan.calls[array_size(out.call)];
    frame.size[o] = port_of(call, out).space->size;
    if (frame.origin[o] < 0) continue;
    frame.at[o] = frame.words;
    frame.words += frame.size[o];
    if (const int most = told_earlier<Graph>::most(o); most > 0) {
      frame.earlier[o] = frame.words;
      frame.words += 2 + most * (1 + frame.size[o]);
    }
  }
  frame.words = (frame.words + 7) / 8 * 8;  // whole lines of the cache
  return frame;
}();

template <class Graph>
inline constexpr const auto& frame_layout_of<probed<Graph>> = frame_layout_of<Graph>;

}  // namespace cca::detail
