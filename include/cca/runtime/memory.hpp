// What a controller remembers between beats: components, and of the samples only what a later beat reads.
// All of it is plain values, so a copy is a snapshot.
#pragma once

#include <array>
#include <cstdint>

#include <cca/graph/lookup.hpp>

namespace cca::detail {

template <class Graph, int Leaf>
struct cell {
  [[no_unique_address]] typename leaf_of<Graph, Leaf>::component component{};
};

// Coordinates and origin of one sample.
template <int Size>
struct coordinates {
  std::array<double, Size> value;
  std::int64_t origin;
};

struct stamp { std::int64_t when = -1; };
struct no_stamp {};

template <class Graph, int Output>
constexpr auto initial_of() {
  constexpr int size = size_of_output<Graph, Output>;
  constexpr const item_info* wire = plan_of<Graph>.outputs[Output].initial_of;
  coordinates<size> sample{{}, never};
  for (int c = 0; c < size; ++c) {
    sample.value[static_cast<std::size_t>(c)] = 0;
    if constexpr (wire && wire->initial) sample.value[static_cast<std::size_t>(c)] = wire->initial[wire->initial_count == 1 ? 0 : c];
  }
  return sample;
}

// The newest sample of an output, where a later beat may read it; its origin is `never` until there is one.
template <class Graph, int Output>
struct kept_sample : coordinates<size_of_output<Graph, Output>>,
                     std::conditional_t<plan_of<Graph>.outputs[Output].stamped, stamp, no_stamp> {
  constexpr kept_sample() : coordinates<size_of_output<Graph, Output>>(initial_of<Graph, Output>()) {}
};

// The last samples of an output, for readers with a delay.
template <class Graph, int Output>
struct past_samples {
  static constexpr int size = plan_of<Graph>.outputs[Output].ring;
  struct entry : coordinates<size_of_output<Graph, Output>>, stamp {};
  std::array<entry, size> entries{};
  std::int64_t count = 0;
};

// What a component whose clock is known only at run time remembers of itself.
struct last_firing {
  std::int64_t last = -1;        // beat, or -1
  std::int64_t oldest = never;   // origin that it saw then
};
template <class Graph, int Turn>
struct turn_memory : last_firing {};

// Samples waiting at an input, and the one that it took last.
template <class Graph, int Input>
struct waiting_samples {
  static constexpr int capacity = plan_of<Graph>.inputs[Input].wire->number;
  static constexpr int size = size_of_input<Graph, Input>;
  std::array<coordinates<size>, capacity> ring{};
  coordinates<size> taken{};
  int head = 0, count = 0;
  constexpr waiting_samples() { taken.origin = never; }
};

template <class Graph, class Cells, class Kept, class Past, class Turns, class Queues>
struct memory_of;

template <class Graph, int... L, int... K, int... P, int... T, int... Q>
struct memory_of<Graph, std::integer_sequence<int, L...>, std::integer_sequence<int, K...>, std::integer_sequence<int, P...>,
                 std::integer_sequence<int, T...>, std::integer_sequence<int, Q...>>
    : cell<Graph, L>..., kept_sample<Graph, K>..., past_samples<Graph, P>..., turn_memory<Graph, T>..., waiting_samples<Graph, Q>... {};

template <class Graph>
struct is_kept { static constexpr bool holds(std::size_t o) { return plan_of<Graph>.outputs[o].kept; } };
template <class Graph>
struct has_past { static constexpr bool holds(std::size_t o) { return plan_of<Graph>.outputs[o].ring > 0; } };
template <class Graph>
struct is_dynamic { static constexpr bool holds(std::size_t t) { return plan_of<Graph>.turns[t].fires.dynamic(); } };
template <class Graph>
struct is_queue { static constexpr bool holds(std::size_t i) { return plan_of<Graph>.inputs[i].queue >= 0; } };
template <class Graph>
struct is_local { static constexpr bool holds(std::size_t o) { return plan_of<Graph>.outputs[o].local; } };

template <class Graph>
struct memory : memory_of<Graph, std::make_integer_sequence<int, counts_of<Graph>.leaf_count>, chosen<counts_of<Graph>.output_count, is_kept<Graph>>,
                          chosen<counts_of<Graph>.output_count, has_past<Graph>>, chosen<counts_of<Graph>.turn_count, is_dynamic<Graph>>,
                          chosen<counts_of<Graph>.input_count, is_queue<Graph>>> {};

// Samples that live for one beat. They are written before they are read, by the order of the beat; where it is known
// only at run time whether one is published, it says so.
template <int Size>
struct sure_sample : coordinates<Size> {};
template <int Size>
struct possible_sample : coordinates<Size> {
  bool published = false;
  constexpr possible_sample() : coordinates<Size>{} {}
};

template <class Graph, int Output>
inline constexpr bool is_sure = !published_of<Graph, Output>.dynamic();

template <class Graph, int Output>
struct local_sample : std::conditional_t<is_sure<Graph, Output>, sure_sample<size_of_output<Graph, Output>>,
                                         possible_sample<size_of_output<Graph, Output>>> {};

template <class Graph, class Outputs>
struct locals_of;
template <class Graph, int... O>
struct locals_of<Graph, std::integer_sequence<int, O...>> : local_sample<Graph, O>... {};

template <class Graph>
struct locals : locals_of<Graph, chosen<counts_of<Graph>.output_count, is_local<Graph>>> {};

}  // namespace cca::detail
