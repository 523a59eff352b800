// Where everything lies in memory. Equal things lie side by side in one array, so a place is an array and an
// index in it.
//
// Calls are twins if they call the same function of the same component type, and fire, read and publish in
// the same way: they differ only in the places that they touch. The code of a call is compiled once for all
// its twins.
//
// Cost: a chain of a thousand equal nodes compiles as two different ones, a thousand times inlined.
#pragma once

#include <bit>

#include <cca/base/array_size.hpp>
#include <cca/graph/planning/plan.hpp>

namespace cca::detail {

struct place {
  int array = -1, index = 0;  // array -1: nowhere
};

// Samples that are stored in the same way.
struct sample_array {
  storage_kind kind = storage_kind::none;
  int size = 0;               // coordinates of a sample
  int depth = 0;              // of the past, of a queue, or the delay of what is on its way into one
  int in_a_beat = 1;          // on_the_way: how many samples may be published in one beat
  clock published{};          // newest, past
  int call = -1;              // of_beat: the first call of the same function, whose result it is
  bool in_each_beat = false;  // of_beat: the result is there in each beat
  full_kind full = full_kind::drop_oldest;  // queue
  bool counts_vary = false;                 // queue: it keeps of each sample whether it counts for the origin
  bool counts_arrivals = false;             // queue: a strategy may ask how many samples came in a beat
  int count = 0;

  constexpr bool stores_like(const sample_array& other) const {
    return kind == other.kind && size == other.size && depth == other.depth && in_a_beat == other.in_a_beat &&
           published == other.published && call == other.call && in_each_beat == other.in_each_beat &&
           full == other.full && counts_vary == other.counts_vary && counts_arrivals == other.counts_arrivals;
  }
};

// What differs between twins.
struct call_place {
  int node = 0, component = 0;  // index in its array
  int firing = -1;              // index of its last firing, or -1
  int missed = -1;              // index of the firing that it missed, or -1
  int result = -1;              // index of what it returns, or -1
  int first_input = 0, first_output = 0;
};

// The first number of each key, by open addressing. Keys are 64 well-mixed bits: equal ones mean equal facts.
template <int Count>
struct first_of_key {
  static constexpr auto mask = table_size(Count) - 1;
  int numbers[mask + 1]{};  // one more than the number; 0: none
  std::uint64_t keys[mask + 1]{};

  constexpr int first(std::uint64_t key, int number) {
    auto at = key & mask;
    while (numbers[at] != 0 && keys[at] != key) at = (at + 1) & mask;
    if (numbers[at] == 0) {
      numbers[at] = number + 1;
      keys[at] = key;
    }
    return numbers[at] - 1;
  }
};

template <int Nodes, int Calls, int Inputs, int Outputs>
struct layout {
  static constexpr int max_arrays = Calls + Outputs + 2 * Inputs + 1;
  place components[array_size(Nodes + 1)]{};      // array: the first component of the same type
  int component_counts[array_size(Nodes + 1)]{};  // of the array of this number
  int twin[array_size(Calls + 1)]{};              // the first call that is a twin
  int input_twin[array_size(Inputs + 1)]{};       // the first input that reads in the same way
  int output_twin[array_size(Outputs + 1)]{};     // the first output that is published in the same way
  call_place calls[array_size(Calls + 1)]{};
  place results[array_size(Calls + 1)]{};      // what a call returns, where readers of the beat read it
  place outputs[array_size(Outputs + 1)]{};    // newest, past
  place sources[array_size(Inputs + 1)]{};     // what the input reads; a queue is its own
  place on_the_way[array_size(Inputs + 1)]{};  // of a way into a queue: what has not arrived yet
  sample_array arrays[array_size(max_arrays)]{};
  int array_count = 0, firing_count = 0, missed_count = 0;

  using node_keys = first_of_key<Nodes>;
  using call_keys = first_of_key<Calls>;
  using input_keys = first_of_key<Inputs>;
  using output_keys = first_of_key<Outputs>;
};

// Coordinate c of the initial value that a wire gives; without one, of the space's zero.
constexpr double initial_coordinate(ref<item_info> wire, const space_info& space, int c) {
  return wire && wire->initial ? wire->initial[wire->initial_count == 1 ? 0 : c] : space.zero[c];
}

// All facts in one call: a call costs the compilers more than the computation.
template <class... Facts>
constexpr std::uint64_t mixed(std::uint64_t key, Facts... facts) {
  ((key = key * std::uint64_t{0x9e3779b97f4a7c15} + static_cast<std::uint64_t>(facts)), ...);
  return key ^ key >> 29;
}

template <class Layout>
struct layout_step {
  const flat_view& g;
  Layout& to;

  constexpr int array_like(const sample_array& wanted) {
    int array = 0;
    while (array < to.array_count && !to.arrays[array].stores_like(wanted)) ++array;
    if (array == to.array_count) to.arrays[to.array_count++] = wanted;
    return array;
  }
  constexpr place place_in(const sample_array& wanted) {
    const int array = array_like(wanted);
    return {array, to.arrays[array].count++};
  }

  constexpr void place_components() {
    typename Layout::node_keys types;
    for (int n = 0; n < g.node_count; ++n) {
      const auto& c = g.calls[g.nodes[n].first_call];
      if (c.elsewhere) continue;
      // In a replay those of free-running environments are of another type (record/replay/replayed.hpp).
      const std::uint64_t key = g.nodes[n].item->component->key;
      const int first = types.first(c.irregular ? mixed(key, 1) : key, n);
      to.components[n] = {first, to.component_counts[first]++};
    }
  }

  constexpr bool is_read_in_beat(const call& c) const {
    for (int o = c.first_output; o < c.first_output + c.function->output_count; ++o) {
      if (g.outputs[o].storage == storage_kind::of_beat) return true;
      for (int i = g.outputs[o].first_reader; i >= 0; i = g.inputs[i].next_of_writer)
        if (reads_result(g.inputs[i])) return true;
    }
    return false;
  }
  // It reads in the beat what a ring keeps for others, and finds it where the component returned it: any
  // sample that the beat stores later might be the same place of a ring.
  constexpr bool reads_result(const input& in) const {
    return in.writer >= 0 && g.outputs[in.writer].storage == storage_kind::past && in.known_now &&
           in.delay == 0 && in.queue < 0 && !in.watched && !in.outside && !g.calls[in.call].elsewhere &&
           in_one_part(g, in.call, g.outputs[in.writer].call);
  }

  // In each beat, or at least in each beat in which a reader looks.
  constexpr bool is_there_when_read(const call& c) const {
    if (c.fires.every_beat()) return true;
    if (!c.own_clock.every_beat()) return false;
    for (int o = c.first_output; o < c.first_output + c.function->output_count; ++o) {
      if (port_of(g, g.outputs[o]).maybe) return false;
      for (int i = g.outputs[o].first_reader; i >= 0; i = g.inputs[i].next_of_writer)
        if (!g.inputs[i].known_now && g.inputs[i].queue < 0) return false;
    }
    return true;
  }

  // Results are used again by each part of a long beat.
  constexpr void place_results() {
    typename Layout::call_keys functions;
    int used[Layout::max_arrays]{};
    for (int r = 0; r < g.order_count; ++r) {
      const int index = g.order[r];
      const auto& c = g.calls[index];
      if (r % g.calls_in_part == 0)
        for (int array = 0; array < to.array_count; ++array) used[array] = 0;
      if (!is_read_in_beat(c)) continue;
      const int first =
          functions.first(mixed(static_cast<std::uint64_t>(to.components[c.node].array), c.phase), index);
      const int array =
          array_like({.kind = storage_kind::of_beat, .call = first, .in_each_beat = is_there_when_read(c)});
      to.results[index] = {array, used[array]++};
      if (used[array] > to.arrays[array].count) to.arrays[array].count = used[array];
    }
  }

  constexpr void place_samples() {
    for (int o = 0; o < g.output_count; ++o) {
      const auto& out = g.outputs[o];
      if (out.storage == storage_kind::of_beat) to.outputs[o] = to.results[out.call];
      else if (out.storage != storage_kind::none)
        to.outputs[o] = place_in({.kind = out.storage,
                                  .size = port_of(g, out).space->size,
                                  .depth = out.depth,
                                  .published = stored_clock(g, out)});
    }
    for (int i = 0; i < g.input_count; ++i) {
      const auto& in = g.inputs[i];
      if (g.calls[in.call].elsewhere) continue;
      if (in.way_of >= 0) to.sources[i] = to.sources[in.way_of];
      else if (in.queue >= 0)
        to.sources[i] = place_in({.kind = storage_kind::queue,
                                  .size = coordinates_of(g, in),
                                  .depth = in.wire->capacity,
                                  .full = in.wire->full,
                                  .counts_vary = in.counts_vary,
                                  .counts_arrivals = in.counts_arrivals});
      else if (in.shows >= 0) to.sources[i] = to.sources[in.shows];
      else if (reads_result(in)) to.sources[i] = to.results[g.outputs[in.writer].call];
      else if (in.writer >= 0) to.sources[i] = to.outputs[in.writer];
      if (is_on_the_way(in) && !g.calls[g.outputs[in.writer].call].elsewhere)
        to.on_the_way[i] = place_in({.kind = storage_kind::on_the_way,
                                     .size = coordinates_of(g, in),
                                     .depth = in.delay,
                                     .in_a_beat = g.outputs[in.writer].in_a_beat});
    }
  }

  constexpr void place_calls() {
    for (int c = 0; c < g.call_count; ++c) {
      const auto& one = g.calls[c];
      to.calls[c] = {one.node,
                     to.components[one.node].index,
                     one.own_clock.dynamic() && !one.elsewhere ? to.firing_count++ : -1,
                     one.may_miss ? to.missed_count++ : -1,
                     to.results[c].array < 0 ? -1 : to.results[c].index,
                     one.first_input,
                     one.first_output};
    }
  }

  // Can it show an initial value that is not the stored sample's?
  constexpr bool shows_initial(const input& in) const {
    return in.writer < 0 || in.queue >= 0 || in.own_initial ||
           g.outputs[in.writer].storage == storage_kind::arriving;
  }

  constexpr std::uint64_t key_of(const input& in, int source) const {
    std::uint64_t key = static_cast<std::uint64_t>(source);
    if (in.writer >= 0) {
      const auto& from = g.outputs[in.writer];
      const auto c = published(g, from);
      key = mixed(key, c.period, c.first, in.delay,
                  in.in_beat | in.own_initial << 1 | in.counts << 2 | in.known_now << 3 | in.counts_vary << 4,
                  from.storage == storage_kind::of_beat || reads_result(in) ? from.port : -1);
    }
    if (shows_initial(in))
      if (const auto space = port_of(g, in).space)
        for (int c = 0; c < space->size; ++c)
          key = mixed(key, std::bit_cast<std::int64_t>(initial_coordinate(in.initial, *space, c)));
    return key;
  }

  constexpr std::uint64_t key_of(const output& out, int array) const {
    const auto c = published(g, out);
    return mixed(0, c.period, c.first, out.storage, array,
                 out.storage == storage_kind::of_beat ? out.port : -1);
  }

  constexpr std::uint64_t key_of(const call& c, int result) const {
    std::uint64_t key =
        mixed(item_of_call(g, c).strategy_key, to.components[c.node].array, c.phase, c.own_clock.period,
              c.own_clock.first, c.unsteady | c.other_clocks << 1 | c.may_miss << 2, result,
              g.nodes[c.node].part, c.fast_clock.period, c.fast_clock.first);
    for (int i = c.first_input; i < c.first_input + c.function->input_count; ++i)
      key = mixed(key, to.input_twin[i]);
    for (int o = c.first_output; o < c.first_output + c.function->output_count; ++o)
      key = mixed(key, to.output_twin[o]);
    return key;
  }

  static constexpr int most_compared = 1024;

  // Observers read, queues are filled, and samples leave by the numbers of the ports: these have no twins. To
  // compare the initial values of large samples would take the compilers long.
  constexpr bool is_unique(const input& in) const {
    const auto space = port_of(g, in).space;
    return !space || in.outside || g.calls[in.call].elsewhere || space->size > most_compared;
  }
  // What stops and starts parts, or tells what it takes from queues, looks these up by its own number.
  constexpr bool is_unique(const call& c) const {
    return c.elsewhere || c.tells_taken || c.function->asked_count > 0 || strategy_of_call(g, c).keeps_state;
  }
  constexpr bool is_unique(const output& out) const {
    if (out.leaves || out.is_taken || g.calls[out.call].elsewhere) return true;
    if (g.queue_count == 0) return false;
    for (int i = out.first_reader; i >= 0; i = g.inputs[i].next_of_writer)
      if (g.inputs[i].queue >= 0) return true;
    return false;
  }

  constexpr void find_twins() {
    typename Layout::input_keys inputs;
    typename Layout::output_keys outputs;
    typename Layout::call_keys calls;
    for (int i = 0; i < g.input_count; ++i)
      to.input_twin[i] =
          is_unique(g.inputs[i]) ? i : inputs.first(key_of(g.inputs[i], to.sources[i].array), i);
    for (int o = 0; o < g.output_count; ++o)
      to.output_twin[o] =
          is_unique(g.outputs[o]) ? o : outputs.first(key_of(g.outputs[o], to.outputs[o].array), o);
    for (int c = 0; c < g.call_count; ++c)
      to.twin[c] = is_unique(g.calls[c]) ? c : calls.first(key_of(g.calls[c], to.results[c].array), c);
  }

  // Written out: in a constant some elements of an array get zeros instead of their default values
  // (docs/compilers.md).
  constexpr void place_nowhere() {
    for (place& p : to.components) p = {-1, 0};
    for (place& p : to.results) p = {-1, 0};
    for (place& p : to.outputs) p = {-1, 0};
    for (place& p : to.sources) p = {-1, 0};
    for (place& p : to.on_the_way) p = {-1, 0};
  }

  constexpr void run() {
    place_nowhere();
    place_components();
    place_results();
    place_samples();
    place_calls();
    find_twins();
  }
};

template <class Graph>
inline constexpr auto layout_of = [] {
  constexpr auto& size = graph_size<Graph>;
  layout<size.nodes, size.calls, input_count_of<Graph>, output_room_of<Graph>> result;
  const auto& plan = plan_of<Graph>;
  const auto view = plan.view();
  layout_step<decltype(result)>{view, result}.run();
  return result;
}();

}  // namespace cca::detail
