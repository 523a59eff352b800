// What a beat works on, and how it ended.
#pragma once

#include <cca/runtime/state.hpp>

namespace cca::detail {

struct beat_outcome {
  const char* fault = nullptr;  // the reason; null: the beat went through
  int node = -1;                // the component that stated it
};

// The arrays of samples that end with the beat. They are written before they are read, by the order of the
// beat.
template <class Graph>
using beat_arrays = chosen<layout_of<Graph>.array_count, ends_with_beat<Graph>>;

template <class Graph, int Array>
struct reference_to_array {
  stored_array<Graph, Array>& array;
};

template <class Graph, class BeatArrays = beat_arrays<Graph>>
struct beat_context;
template <class Graph, int... BeatArray>
struct beat_context<Graph, std::integer_sequence<int, BeatArray...>>
    : reference_to_array<Graph, BeatArray>... {
  controller_state<Graph>& state;
  beat_outcome& outcome;
  std::int64_t k;

  CCA_INLINE beat_context(controller_state<Graph>& s,
                          beat_outcome& o,
                          std::int64_t beat,
                          stored_array<Graph, BeatArray>&... samples)
      : reference_to_array<Graph, BeatArray>{samples}..., state(s), outcome(o), k(beat) {}

  // A stored sample, by its place.
  template <int Array>
  CCA_INLINE auto& at(int index) const {
    if constexpr (array_of<Graph, Array>.kind == storage_kind::of_beat)
      return static_cast<const reference_to_array<Graph, Array>&>(*this).array.all[index];
    else return sample_in<Graph, Array>(state, index);
  }
};

}  // namespace cca::detail
