// What a beat works on: the state that a controller keeps between beats, and the samples that live for one
// beat. Both consist of arrays of equal things (graph/layout/layout.hpp). The state is plain values, so a
// copy is a snapshot.
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <cca/base/array_size.hpp>
#include <cca/graph/layout/lookup.hpp>
#include <cca/graph/marks/recordable.hpp>
#include <cca/runtime/samples/missed_firings.hpp>
#include <cca/runtime/samples/arriving_samples.hpp>
#include <cca/runtime/samples/derived_values.hpp>
#include <cca/runtime/samples/kept_component.hpp>
#include <cca/runtime/samples/queued_samples.hpp>
#include <cca/runtime/samples/stored_samples.hpp>
#include <cca/runtime/observers/trace_link.hpp>

namespace cca::detail {

// The part of a free-running environment: its beats are cycles, and what it tells components of time is of
// the beat in which a cycle begins.
template <class Graph>
inline constexpr bool runs_in_cycles = false;

// ---- components ----

// All components of the type of node `First`, which is the first of them.
template <class Component, int Count>
struct components_of_type {
  kept_component<Component> all[array_size(Count)];
  CCA_INLINE Component& at(int index) { return all[index].component; }
  CCA_INLINE const Component& at(int index) const { return all[index].component; }
};
// Those without state are one and the same.
template <class Component, int Count>
  requires(std::is_empty_v<Component> && std::is_default_constructible_v<Component>)
struct components_of_type<Component, Count> {
  [[no_unique_address]] Component one;
  components_of_type() : one() {}
  CCA_INLINE Component& at(int) { return one; }
  CCA_INLINE const Component& at(int) const { return one; }
};
template <class Graph, int First>
struct component_array : components_of_type<typename node_types<Graph, First>::component,
                                            layout_of<Graph>.component_counts[First]> {};

// ---- samples ----

template <class Graph, int Array, storage_kind Kind = array_of<Graph, Array>.kind>
struct stored_in;
template <class Graph, int Array>
struct stored_in<Graph, Array, storage_kind::of_beat> {
  static constexpr const auto& a = array_of<Graph, Array>;
  using type = result_of_beat<typename function_called<Graph, a.call>::result, a.in_each_beat>;
};
template <class Graph, int Array>
struct stored_in<Graph, Array, storage_kind::newest> {
  using type = newest_sample<array_of<Graph, Array>.size, array_of<Graph, Array>.published>;
};
// A fault, a rest, a skipped beat, another mode, a gap in a recording: an output is not published at a tick.
template <class Type>
inline constexpr bool may_miss_ticks =
    !Graph<Type> || counts_of<Type>.is_spread || counts_of<Type>.may_fault ||
    counts_of<Type>.part_count > 0 || is_always_probed<Type>;
template <class Graph, int Array>
struct stored_in<Graph, Array, storage_kind::past> {
  static constexpr const auto& a = array_of<Graph, Array>;
  using type = past_samples<a.size, a.depth, a.published, may_miss_ticks<Graph> || !a.published.known()>;
};
template <class Graph, int Array>
struct stored_in<Graph, Array, storage_kind::arriving> {
  static constexpr const auto& a = array_of<Graph, Array>;
  using type = std::conditional_t<runs_in_cycles<Graph>,
                                  samples_for_cycles<a.size, a.depth>,
                                  arriving_samples<a.size, a.depth>>;
};
template <class Graph, int Array>
struct stored_in<Graph, Array, storage_kind::queue> {
  static constexpr const auto& a = array_of<Graph, Array>;
  using type = waiting_samples<a.size, a.depth, a.full, a.counts_vary, a.counts_arrivals>;
};
template <class Graph, int Array>
struct stored_in<Graph, Array, storage_kind::on_the_way> {
  static constexpr const auto& a = array_of<Graph, Array>;
  using type = coming_samples<a.size, a.depth, a.in_a_beat>;
};

template <class Graph, int Array, storage_kind Kind = array_of<Graph, Array>.kind>
struct stored_array {
  typename stored_in<Graph, Array>::type all[static_cast<std::size_t>(array_of<Graph, Array>.count)];
};

// Those of a beat begin with nothing: without a constructor of its own, the array would be set to zero in
// each beat.
template <class Graph, int Array>
struct stored_array<Graph, Array, storage_kind::of_beat> {
  typename stored_in<Graph, Array>::type all[static_cast<std::size_t>(array_of<Graph, Array>.count)];

  CCA_INLINE stored_array() {}
};

// The newest and the past samples begin with what their first reader sees before there is one.
template <class Graph, int Array, storage_kind Kind>
  requires(Kind == storage_kind::newest || Kind == storage_kind::past)
struct stored_array<Graph, Array, Kind> {
  typename stored_in<Graph, Array>::type all[static_cast<std::size_t>(array_of<Graph, Array>.count)];

  stored_array() {
    const auto& plan = plan_of<Graph>;
    for (std::size_t o = 0; o < static_cast<std::size_t>(counts_of<Graph>.output_count); ++o) {
      const place at = layout_of<Graph>.outputs[o];
      if (at.array != Array) continue;
      const auto& out = plan.outputs[o];
      const auto& space = *port_of(plan.calls[static_cast<std::size_t>(out.call)], out).space;
      for (int c = 0; c < array_of<Graph, Array>.size; ++c)
        all[at.index].begin_with(c, initial_coordinate(out.initial_of, space, c));
    }
  }
};

// ---- parts: nodes that may be stopped, components and inner graphs ----
//
// A graph without parts keeps nothing of this. A function of a part has a test, and a part that is stopped
// costs that test.

struct part_state {
  bool is_stopped = false;  // itself
  bool rests = false;       // it, or a part around it
  int asked = 0;            // by a component in this beat: its place in the order, from 1; below 0: to stop
  std::int64_t since = 0;   // the beat in which it was started last
};
template <int Count>
struct part_states {
  std::array<part_state, array_size(Count)> parts{};
  bool is_asked = false;  // anything
};
template <>
struct part_states<0> {};

// In a beat: they do not change while it runs, so all functions of a part that follow each other are one
// test.
template <int Count>
struct resting_parts {
  std::array<bool, array_size(Count)> rests;

  CCA_INLINE explicit resting_parts(const part_states<Count>& now)
      : resting_parts(now, std::make_index_sequence<array_size(Count)>{}) {}

private:
  template <std::size_t... Part>
  CCA_INLINE resting_parts(const part_states<Count>& now, std::index_sequence<Part...>)
      : rests{now.parts[Part].rests...} {}
};
template <>
struct resting_parts<0> {
  CCA_INLINE explicit resting_parts(const part_states<0>&) {}
};

// How many parts the state of a graph has, and the parts: those of a mode are the parts of its whole set
// (runtime/modes/shared_state.hpp).
template <class Graph>
inline constexpr int parts_kept = counts_of<Graph>.part_count;
template <class Graph>
inline constexpr const auto& kept_parts = plan_of<Graph>.parts;
template <class Graph>
inline constexpr int parts_kept<probed<Graph>> = parts_kept<Graph>;
template <class Graph>
inline constexpr const auto& kept_parts<probed<Graph>> = kept_parts<Graph>;

// The innermost part that has the component of a call; -1: none.
template <class Graph, int Call>
inline constexpr int part_of_call_at = plan_of<Graph>.nodes[array_size(call_of<Graph, Call>.node)].part;

// A strategy that has a state, of a call whose clock is known only at run time.
template <class Graph>
struct keeps_strategy {
  static constexpr bool holds(std::size_t c) {
    const auto& plan = plan_of<Graph>;
    const call& one = plan.calls[c];
    const auto strategy = plan.nodes[array_size(one.node)].item->strategy_while_started();
    return one.own_clock.dynamic() && !one.elsewhere && strategy && strategy->keeps_state;
  }
};
template <class Graph, int Call>
struct kept_strategy {
  using stated = typename node_types<Graph, call_of<Graph, Call>.node>::strategy;
  typename strategy_or_default<stated, true>::type strategy{};
};
// Modes share theirs (runtime/modes/shared_state.hpp).
template <class Graph, int Call>
struct place_of_strategy {
  using type = kept_strategy<Graph, Call>;
};

template <class Graph, class Calls = chosen<counts_of<Graph>.call_count, keeps_strategy<Graph>>>
struct kept_strategies;
template <class Graph, int... Call>
struct kept_strategies<Graph, std::integer_sequence<int, Call...>> : kept_strategy<Graph, Call>... {};

// ---- all of it ----

template <class Graph>
struct is_first_of_type {
  static constexpr bool holds(std::size_t n) { return layout_of<Graph>.component_counts[n] > 0; }
};
template <class Graph>
struct outlives_beat {
  static constexpr bool holds(std::size_t a) {
    return layout_of<Graph>.arrays[a].kind != storage_kind::of_beat;
  }
};
template <class Graph>
struct ends_with_beat {
  static constexpr bool holds(std::size_t a) {
    return layout_of<Graph>.arrays[a].kind == storage_kind::of_beat;
  }
};

template <class Graph, class Components, class Samples>
struct state_of;
template <class Graph, int... Component, int... Array>
struct state_of<Graph, std::integer_sequence<int, Component...>, std::integer_sequence<int, Array...>>
    : component_array<Graph, Component>...,
      stored_array<Graph, Array>...,
      last_firings<layout_of<Graph>.firing_count>,
      missed_firings<layout_of<Graph>.missed_count>,
      kept_strategies<Graph> {};

// What outlives a beat.
template <class Graph>
struct controller_state : state_of<Graph,
                                   chosen<counts_of<Graph>.node_count, is_first_of_type<Graph>>,
                                   chosen<layout_of<Graph>.array_count, outlives_beat<Graph>>>,
                          part_states<parts_kept<Graph>>,
                          trace_link<Graph> {};

template <class Part, class Whole>
CCA_INLINE auto& part_of(Whole& whole) {
  return static_cast<std::conditional_t<std::is_const_v<Whole>, const Part, Part>&>(whole);
}

// Where components and samples are kept: modes share theirs (runtime/modes/shared_state.hpp).
template <class Graph, int First>
struct array_of_components {
  using type = component_array<Graph, First>;
};
template <class Graph, int Array>
struct array_of_samples {
  using type = stored_array<Graph, Array>;
};

template <class Graph, int First, class State>
CCA_INLINE auto& component_in(State& state, int index) {
  return part_of<typename array_of_components<Graph, First>::type>(state).at(index);
}
template <class Graph, int Node, class State>
CCA_INLINE auto& component_at(State& state) {
  constexpr place at = layout_of<Graph>.components[Node];
  return component_in<Graph, at.array>(state, at.index);
}

template <class Graph, int Array, class State>
CCA_INLINE auto& sample_in(State& state, int index) {
  return part_of<typename array_of_samples<Graph, Array>::type>(state).all[index];
}

template <class Graph, int Call, class State>
CCA_INLINE auto& strategy_in(State& state) {
  return part_of<typename place_of_strategy<Graph, Call>::type>(state).strategy;
}

// ---- what a beat works on ----

struct beat_outcome {
  const char* fault = nullptr;  // the reason; null: the beat went through
  int node = -1;                // the component that stated it
  int turns = all_turns;        // so many calls had their turn
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
struct references_to_arrays;
template <class Graph, int... Array>
struct references_to_arrays<Graph, std::integer_sequence<int, Array...>>
    : reference_to_array<Graph, Array>... {
  CCA_INLINE explicit references_to_arrays(stored_array<Graph, Array>&... samples)
      : reference_to_array<Graph, Array>{samples}... {}
};

// Its name does not list its arrays (docs/compilers.md).
template <class Graph>
struct beat_context : references_to_arrays<Graph>,
                      frame_of_beat<Graph>,
                      derived_in_beat<Graph>,
                      resting_parts<parts_kept<Graph>>,
                      after_missed<layout_of<Graph>.missed_count> {
  controller_state<Graph>& state;
  beat_outcome& outcome;
  std::int64_t k;

  template <class... Arrays>
  CCA_INLINE beat_context(controller_state<Graph>& s,
                          beat_outcome& o,
                          std::int64_t beat,
                          frame_of_beat<Graph> told,
                          derived_rooms<Graph>&& its_rooms,
                          derived_marks<Graph>&& its_marks,
                          Arrays&&... samples)
      : references_to_arrays<Graph>(samples...),
        frame_of_beat<Graph>(told),
        derived_in_beat<Graph>(its_rooms, its_marks),
        resting_parts<parts_kept<Graph>>(s),
        after_missed<layout_of<Graph>.missed_count>(s, beat),
        state(s),
        outcome(o),
        k(beat) {}

  // A stored sample, by its place.
  template <int Array>
  CCA_INLINE auto& at(int index) const {
    if constexpr (array_of<Graph, Array>.kind == storage_kind::of_beat)
      return static_cast<const reference_to_array<Graph, Array>&>(*this).array.all[index];
    else return sample_in<Graph, Array>(state, index);
  }
};

}  // namespace cca::detail
