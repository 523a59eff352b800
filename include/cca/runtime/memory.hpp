// What a controller remembers between beats: components, and of the samples only what a later beat reads.
// All of it is plain values, so a copy is a snapshot. What is alike lies side by side in one array
// (graph/layout.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include <cca/graph/lookup.hpp>
#include <cca/base/inlining.hpp>

namespace cca::detail {

// All components of one type; `First` is the first of them. Stateless ones are one and the same.
template <class Component>
struct cell {
  static_assert(std::is_default_constructible_v<Component>,
                "cca::controller: a component starts from its default values, so it needs a constructor "
                "without arguments; what differs between nodes is "
                "a template argument or one of its `parameters`");
  [[no_unique_address]] Component component{};
};
template <class Component, int Count>
struct cells {
  cell<Component> all[Count]{};
  CCA_GLUE Component& at(int slot) { return all[slot].component; }
  CCA_GLUE const Component& at(int slot) const { return all[slot].component; }
};
template <class Component, int Count>
  requires std::is_empty_v<Component>
struct cells<Component, Count> {
  [[no_unique_address]] Component one{};
  CCA_GLUE Component& at(int) { return one; }
  CCA_GLUE const Component& at(int) const { return one; }
};
template <class Graph, int First>
struct cells_of : cells<typename node_types<Graph, First>::component, layout_of<Graph>.cell_counts[First]> {};

// Coordinates and origin of one sample.
template <int Size>
struct coordinates {
  double value[Size];
  std::int64_t origin;
};

// One that is surely written before it is read. To make it anew is to say that nobody reads what was there.
template <int Size>
struct sure_sample : coordinates<Size> {
  sure_sample() noexcept {}
};

struct stamp {
  std::int64_t when = -1;
};

// The newest sample of an output, where a later beat may read it; its origin is `never` until there is one.
template <int Size>
struct stamped_sample : coordinates<Size>, stamp {};

// The last samples of an output, for readers with a delay.
template <int Size, int Depth>
struct past_samples {
  static constexpr int depth = Depth;
  stamped_sample<Size> entries[Depth]{};
  std::int64_t count = 0;
};

// Samples waiting at an input, and the one that it took last.
template <int Size, int Capacity>
struct waiting_samples {
  static constexpr int capacity = Capacity;
  coordinates<Size> ring[Capacity]{};
  coordinates<Size> taken{{}, never};
  int head = 0, count = 0;
};

// A sample that may not be published in its beat, known only at run time.
template <int Size>
struct possible_sample : coordinates<Size> {
  bool published = false;
  constexpr possible_sample() : coordinates<Size>{} {}
};

template <storage_kind Kind, int Size, int Depth>
struct stored {
  using type = coordinates<Size>;
};
template <int Size, int Depth>
struct stored<storage_kind::local, Size, Depth> {
  using type = sure_sample<Size>;
};
template <int Size, int Depth>
struct stored<storage_kind::local_if_published, Size, Depth> {
  using type = possible_sample<Size>;
};
template <int Size, int Depth>
struct stored<storage_kind::kept_with_beat, Size, Depth> {
  using type = stamped_sample<Size>;
};
template <int Size, int Depth>
struct stored<storage_kind::past, Size, Depth> {
  using type = past_samples<Size, Depth>;
};
template <int Size, int Depth>
struct stored<storage_kind::queue, Size, Depth> {
  using type = waiting_samples<Size, Depth>;
};

template <class Graph, int Group>
using stored_of = typename stored<group_of<Graph, Group>.kind,
                                  group_of<Graph, Group>.size,
                                  group_of<Graph, Group>.depth>::type;

template <class Graph, int Group, class Stored>
struct initial_samples {
  Stored all[static_cast<std::size_t>(group_of<Graph, Group>.count)];

  constexpr initial_samples() : all{} {
    auto plan = plan_of<Graph>;
    const auto g = plan.view();
    for (int o = 0; o < g.output_count; ++o) {
      const auto place = layout_of<Graph>.newest[o];
      if (place.group != Group) continue;
      auto& sample = all[place.slot];
      sample.origin = never;
      for (int c = 0; c < group_of<Graph, Group>.size; ++c)
        sample.value[c] = initial_coordinate(g.outputs[o].initial_of, *port_of(g, g.outputs[o]).space, c);
    }
  }
};
template <class Graph, int Group>
inline constexpr initial_samples<Graph, Group, stored_of<Graph, Group>> initial_of_group{};

// All samples of a group.
template <class Graph, int Group, storage_kind = group_of<Graph, Group>.kind>
struct storage {
  stored_of<Graph, Group> all[static_cast<std::size_t>(group_of<Graph, Group>.count)];
};
template <class Graph, int Group>
struct storage<Graph, Group, storage_kind::kept> : initial_samples<Graph, Group, stored_of<Graph, Group>> {
  constexpr storage()
      : initial_samples<Graph, Group, stored_of<Graph, Group>>(initial_of_group<Graph, Group>) {}
};
template <class Graph, int Group>
struct storage<Graph, Group, storage_kind::kept_with_beat>
    : initial_samples<Graph, Group, stored_of<Graph, Group>> {
  constexpr storage()
      : initial_samples<Graph, Group, stored_of<Graph, Group>>(initial_of_group<Graph, Group>) {}
};

// One by one and not as an array: a loop that sets them up would keep all of them out of registers.
template <class Graph, int Group, class Slots>
struct possible_samples;
template <class Graph, int Group, int... Slot>
struct possible_samples<Graph, Group, std::integer_sequence<int, Slot...>> {
  stored_of<Graph, Group> all[sizeof...(Slot)]{(void(Slot), stored_of<Graph, Group>())...};
};
template <class Graph, int Group>
struct storage<Graph, Group, storage_kind::local_if_published>
    : possible_samples<Graph, Group, std::make_integer_sequence<int, group_of<Graph, Group>.count>> {};

// What a component whose clock is known only at run time remembers of itself.
struct last_firing {
  std::int64_t last = -1;       // beat, or -1
  std::int64_t oldest = never;  // origin that it saw then
};
template <int Count>
struct last_firings {
  last_firing firings[Count]{};
};
template <>
struct last_firings<0> {};

template <class Graph, class Cells, class Groups>
struct memory_of;
template <class Graph, int... C, int... S>
struct memory_of<Graph, std::integer_sequence<int, C...>, std::integer_sequence<int, S...>>
    : cells_of<Graph, C>..., storage<Graph, S>..., last_firings<layout_of<Graph>.firing_count> {};

template <class Graph>
struct is_first_cell {
  static constexpr bool holds(std::size_t l) { return layout_of<Graph>.cell_counts[l] > 0; }
};
template <class Graph>
struct outlives_beat {
  static constexpr bool holds(std::size_t s) { return !layout_of<Graph>.groups[s].in_beat(); }
};
template <class Graph>
struct ends_with_beat {
  static constexpr bool holds(std::size_t s) { return layout_of<Graph>.groups[s].in_beat(); }
};

template <class Graph>
struct memory : memory_of<Graph,
                          chosen<counts_of<Graph>.node_count, is_first_cell<Graph>>,
                          chosen<layout_of<Graph>.group_count, outlives_beat<Graph>>> {};

// Samples that live for one beat. They are written before they are read, by the order of the beat; where it
// is known only at run time whether one is published, it says so.
template <class Graph, class Groups>
struct locals_of;
template <class Graph, int... S>
struct locals_of<Graph, std::integer_sequence<int, S...>> : storage<Graph, S>... {};
template <class Graph>
struct locals : locals_of<Graph, chosen<layout_of<Graph>.group_count, ends_with_beat<Graph>>> {};

template <class Part, class Whole>
CCA_GLUE auto& part_of(Whole& whole) {
  return static_cast<std::conditional_t<std::is_const_v<Whole>, const Part, Part>&>(whole);
}

template <class Graph, int Group, class Memory, class Locals>
CCA_GLUE auto& stored_at(Memory& m, Locals& l, int slot) {
  if constexpr (group_of<Graph, Group>.in_beat()) return part_of<storage<Graph, Group>>(l).all[slot];
  else return part_of<storage<Graph, Group>>(m).all[slot];
}

template <class Graph, int First, class Memory>
CCA_GLUE auto& cells_at(Memory& m) {
  return part_of<cells_of<Graph, First>>(m);
}

template <class Graph, int Node, class Memory>
CCA_GLUE auto& component_at(Memory& m) {
  constexpr seat place = layout_of<Graph>.cells[Node];
  return cells_at<Graph, place.group>(m).at(place.slot);
}

template <class Graph, int Output>
inline constexpr bool is_sure = !published_of<Graph, Output>.dynamic();

// Where something lies; empty where there is nothing.
template <class Stored>
struct reference {
  Stored& at;
};
struct no_reference {};

template <class Graph, int Group>
CCA_GLUE auto refer(memory<Graph>& m, locals<Graph>& l, int slot) {
  if constexpr (Group < 0) return no_reference{};
  else return reference<stored_of<Graph, Group>>{stored_at<Graph, Group>(m, l, slot)};
}
template <class Graph, int Group>
using reference_to =
    decltype(refer<Graph, Group>(std::declval<memory<Graph>&>(), std::declval<locals<Graph>&>(), 0));

// Where one input reads, and where one output goes: for all that are alike.
template <class Graph, int Input>
struct input_seat : reference_to<Graph, layout_of<Graph>.sources[Input].group> {};
template <class Graph, int Output>
struct output_seat {
  [[no_unique_address]] reference_to<Graph, layout_of<Graph>.newest[Output].group> newest;
  [[no_unique_address]] reference_to<Graph, layout_of<Graph>.past[Output].group> past;
};

template <int Position, class Seat>
struct input_at {
  Seat seat;
};
template <int Position, class Seat>
struct output_at {
  Seat seat;
};
template <int Position, class Seat>
CCA_GLUE const Seat& input_in(const input_at<Position, Seat>& place) {
  return place.seat;
}
template <int Position, class Seat>
CCA_GLUE const Seat& output_in(const output_at<Position, Seat>& place) {
  return place.seat;
}

// All places that a function of the beat touches. They are of one type for all functions that read and
// publish alike; the numbers of the ports are constants once this is inlined.
template <class Graph, class Inputs, class LikeInputs, class Outputs, class LikeOutputs>
struct seats_of;
template <class Graph, int... P, int... Input, int... Q, int... Output>
struct seats_of<Graph,
                std::integer_sequence<int, P...>,
                std::integer_sequence<int, Input...>,
                std::integer_sequence<int, Q...>,
                std::integer_sequence<int, Output...>> : input_at<P, input_seat<Graph, Input>>...,
                                                         output_at<Q, output_seat<Graph, Output>>... {
  CCA_GLUE seats_of([[maybe_unused]] memory<Graph>& m,
                    [[maybe_unused]] locals<Graph>& l,
                    [[maybe_unused]] const call_place& of)
      : input_at<P, input_seat<Graph, Input>>{{{refer<Graph, layout_of<Graph>.sources[Input].group>(
            m, l, layout_of<Graph>.sources[of.first_input + P].slot)}}}...,
        output_at<Q, output_seat<Graph, Output>>{
            {refer<Graph, layout_of<Graph>.newest[Output].group>(
                 m, l, layout_of<Graph>.newest[of.first_output + Q].slot),
             refer<Graph, layout_of<Graph>.past[Output].group>(
                 m, l, layout_of<Graph>.past[of.first_output + Q].slot)}}... {}
};

template <class Graph, int Call>
using seats = seats_of<Graph,
                       input_positions<Graph, Call>,
                       inputs_like<Graph, Call>,
                       output_positions<Graph, Call>,
                       outputs_like<Graph, Call>>;

}  // namespace cca::detail
