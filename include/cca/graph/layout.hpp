// The layout of a graph in memory: what is alike lies side by side in one array, and functions that are alike
// are compiled once. Two functions are alike if they are the same function of the same component type, and
// fire, read and publish in the same way; what is special of each is only where its component and its samples
// lie.
//
// Cost: a chain of a thousand equal nodes compiles as two different ones, a thousand times inlined.
#pragma once

#include <bit>

#include <cca/graph/plan/plan.hpp>

namespace cca::detail {

// A place in an array; `group` -1: none.
struct seat {
  int group = -1, slot = 0;
};

enum class storage_kind : std::uint8_t { local, local_if_published, kept, kept_with_beat, past, queue };

struct storage_group {
  storage_kind kind = storage_kind::local;
  int size = 0;   // coordinates
  int depth = 0;  // of a past or a queue
  int count = 0;
  constexpr bool in_beat() const {
    return kind == storage_kind::local || kind == storage_kind::local_if_published;
  }
};

// What is special of each function of a beat.
struct call_place {
  int node = 0, component = 0;  // its slot
  int firing = -1;              // the place of its last firing, or -1
  int first_input = 0, first_output = 0;
};

// The first number of each key, by open addressing. Keys are of 64 well-mixed bits: equal ones mean equal
// facts.
template <int Count>
struct likeness {
  static constexpr auto mask = table_size(Count) - 1;
  int numbers[mask + 1]{};  // one more than the number; 0: none
  std::uint64_t keys[mask + 1]{};

  constexpr int first_alike(std::uint64_t key, int number) {
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
  static constexpr int max_groups = 2 * Outputs + Inputs + 1;
  seat cells[Nodes + 1]{};         // group: the first component of the same type
  int cell_counts[Nodes + 1]{};    // of the group of this number
  int like[Calls + 1]{};           // the first function that is alike
  int like_input[Inputs + 1]{};    // the first input that is read alike
  int like_output[Outputs + 1]{};  // the first output that is published alike
  call_place calls[Calls + 1]{};
  seat newest[Outputs + 1]{};  // kept, or a local of the beat
  seat past[Outputs + 1]{};
  seat sources[Inputs + 1]{};  // what the input reads; of a queue, its own
  storage_group groups[max_groups]{};
  int group_count = 0, firing_count = 0;

  using like_types = likeness<Nodes>;
  using like_calls = likeness<Calls>;
  using like_inputs = likeness<Inputs>;
  using like_outputs = likeness<Outputs>;
};

// Coordinate c of the initial value that a wire gives; without one, of the space's zero.
constexpr double initial_coordinate(ref<item_info> wire, const space_info& space, int c) {
  return wire && wire->initial ? wire->initial[wire->initial_count == 1 ? 0 : c] : space.zero[c];
}

// All facts in one call: to call a function costs the compilers more than to compute.
template <class... Facts>
constexpr std::uint64_t mixed(std::uint64_t key, Facts... facts) {
  ((key = key * 0x9e3779b97f4a7c15ull + static_cast<std::uint64_t>(facts)), ...);
  return key ^ key >> 29;
}

template <class Layout>
struct laying_out {
  const flat_view& g;
  Layout& to;

  constexpr int group_of_kind(storage_kind kind, int size, int depth = 0) {
    int group = 0;
    while (group < to.group_count && !(to.groups[group].kind == kind && to.groups[group].size == size &&
                                       to.groups[group].depth == depth))
      ++group;
    if (group == to.group_count) to.groups[to.group_count++] = {kind, size, depth, 0};
    return group;
  }
  constexpr seat place(storage_kind kind, int size, int depth = 0) {
    const int group = group_of_kind(kind, size, depth);
    return {group, to.groups[group].count++};
  }

  constexpr void place_components() {
    typename Layout::like_types types;
    for (int l = 0; l < g.node_count; ++l) {
      const int first = types.first_alike(g.nodes[l].item->component->key, l);
      to.cells[l] = {first, to.cell_counts[first]++};
    }
  }

  // Each part of a beat has its own locals.
  constexpr void place_locals() {
    int used[Layout::max_groups]{};
    for (int r = 0; r < g.call_count; ++r) {
      const auto& t = g.calls[g.order[r]];
      if (r % g.calls_in_part == 0)
        for (int group = 0; group < to.group_count; ++group) used[group] = 0;
      for (int o = t.first_output; o < t.first_output + t.function->output_count; ++o) {
        if (g.outputs[o].kept || !g.outputs[o].local) continue;
        // What is written in each beat needs no first value; of the rest g++ would warn that it may be read
        // before.
        const bool sure = published(g, g.outputs[o]).every_beat();
        const int group = group_of_kind(sure ? storage_kind::local : storage_kind::local_if_published,
                                        port_of(g, g.outputs[o]).space->size);
        to.newest[o] = {group, used[group]++};
        if (used[group] > to.groups[group].count) to.groups[group].count = used[group];
      }
    }
  }

  constexpr void place_samples() {
    for (int o = 0; o < g.output_count; ++o) {
      const auto& out = g.outputs[o];
      const int size = port_of(g, out).space->size;
      if (out.kept)
        to.newest[o] = place(out.stamped ? storage_kind::kept_with_beat : storage_kind::kept, size);
      if (out.ring > 0) to.past[o] = place(storage_kind::past, size, out.ring);
    }
    for (int i = 0; i < g.input_count; ++i) {
      const auto& in = g.inputs[i];
      if (in.queue >= 0)
        to.sources[i] = place(storage_kind::queue, port_of(g, in).space->size, in.wire->number);
      else if (in.writer >= 0)
        to.sources[i] = in.delay > 0 && !in.is_kept ? to.past[in.writer] : to.newest[in.writer];
    }
    for (int t = 0; t < g.call_count; ++t) {
      const auto& one = g.calls[t];
      to.calls[t] = {one.node, to.cells[one.node].slot, one.fires.dynamic() ? to.firing_count++ : -1,
                     one.first_input, one.first_output};
    }
  }

  // Not from where the sample lies, but as it is for this input alone.
  constexpr bool shows_initial(const input& in) const {
    return in.writer < 0 || in.queue >= 0 || in.own_initial || (in.delay > 0 && !in.is_kept);
  }

  constexpr std::uint64_t key_of(const input& in, int source) const {
    std::uint64_t key = static_cast<std::uint64_t>(source);
    if (in.writer >= 0) {
      const auto c = published(g, g.outputs[in.writer]);
      key = mixed(key, c.period, c.first, in.delay,
                  in.is_kept | in.in_beat << 1 | in.own_initial << 2 | in.counts << 3 | in.is_last << 4);
    }
    if (shows_initial(in))
      if (const auto space = port_of(g, in).space)
        for (int c = 0; c < space->size; ++c)
          key = mixed(key, std::bit_cast<std::int64_t>(initial_coordinate(in.wire, *space, c)));
    return key;
  }

  constexpr std::uint64_t key_of(const output& out, int newest, int past) const {
    const auto c = published(g, out);
    return mixed(0, c.period, c.first, newest, past);
  }

  constexpr std::uint64_t key_of(const call& t) const {
    std::uint64_t key = mixed(item_of_call(g, t).strategy_key, to.cells[t.node].group, t.phase,
                              t.fires.period, t.fires.first);
    for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i)
      key = mixed(key, to.like_input[i]);
    for (int o = t.first_output; o < t.first_output + t.function->output_count; ++o)
      key = mixed(key, to.like_output[o]);
    return key;
  }

  // Observers read, and queues are filled, by the numbers of the ports.
  constexpr bool is_special(const input& in) const { return in.writer < 0 && !port_of(g, in).space; }
  constexpr bool is_special(const output& out) const {
    if (g.queue_count == 0) return false;
    for (int i = out.first_reader; i >= 0; i = g.inputs[i].next_of_writer)
      if (g.inputs[i].queue >= 0) return true;
    return false;
  }

  constexpr void find_alike() {
    typename Layout::like_inputs inputs;
    typename Layout::like_outputs outputs;
    typename Layout::like_calls functions;
    for (int i = 0; i < g.input_count; ++i)
      to.like_input[i] =
          is_special(g.inputs[i]) ? i : inputs.first_alike(key_of(g.inputs[i], to.sources[i].group), i);
    for (int o = 0; o < g.output_count; ++o)
      to.like_output[o] =
          is_special(g.outputs[o])
              ? o
              : outputs.first_alike(key_of(g.outputs[o], to.newest[o].group, to.past[o].group), o);
    for (int t = 0; t < g.call_count; ++t) to.like[t] = functions.first_alike(key_of(g.calls[t]), t);
  }

  constexpr void run() {
    place_components();
    place_locals();
    place_samples();
    find_alike();
  }
};

template <class Graph>
inline constexpr auto layout_of = [] {
  constexpr auto& size = graph_size<Graph>;
  layout<size.nodes, size.calls, size.inputs, size.outputs> result;
  auto plan = plan_of<Graph>;
  const auto view = plan.view();
  laying_out<decltype(result)>{view, result}.run();
  return result;
}();

}  // namespace cca::detail
