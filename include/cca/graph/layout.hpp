// The layout of a graph in memory: what is alike lies side by side in one array, and functions that are alike are compiled
// once. Two functions are alike if they are the same function of the same component type, and fire, read and publish in
// the same way; what is special of each is only where its component and its samples lie.
//
// Cost: a chain of a thousand equal nodes compiles as two different ones, a thousand times inlined.
#pragma once

#include <cca/graph/plan.hpp>

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
  constexpr bool in_beat() const { return kind == storage_kind::local || kind == storage_kind::local_if_published; }
};

template <int Leaves, int Turns, int Inputs, int Outputs>
struct layout {
  seat cells[Leaves + 1]{};       // group: the first component of the same type
  int cell_counts[Leaves + 1]{};  // of the group of this number
  int like[Turns + 1]{};          // the first function that is alike
  int firings[Turns + 1]{};       // the place of its last firing, or -1
  seat newest[Outputs + 1]{};     // kept, or a local of the beat
  seat past[Outputs + 1]{};
  seat sources[Inputs + 1]{};     // what the input reads; of a queue, its own
  storage_group groups[2 * Outputs + Inputs + 1]{};
  int group_count = 0, firing_count = 0;
};

// Numbers found by a key, by open addressing; `same` decides where keys are equal.
struct likeness {
  scratch numbers;
  std::uint64_t mask;
  explicit constexpr likeness(int count) : numbers(static_cast<int>(table_size(count)), -1), mask(table_size(count) - 1) {}

  template <class Same>
  constexpr int first_alike(std::uint64_t key, int number, Same same) {
    for (auto at = key & mask;; at = (at + 1) & mask) {
      int& found = numbers[static_cast<int>(at)];
      if (found < 0) return found = number;
      if (same(found, number)) return found;
    }
  }
};

constexpr std::uint64_t mixed(std::uint64_t key, std::int64_t fact) {
  key = (key ^ static_cast<std::uint64_t>(fact)) * 0x9e3779b97f4a7c15ull;
  return key ^ (key >> 29);
}

template <class Layout>
struct laying_out {
  const flat_view& g;
  Layout& to;

  constexpr int group_of_kind(storage_kind kind, int size, int depth = 0) {
    int group = 0;
    while (group < to.group_count && !(to.groups[group].kind == kind && to.groups[group].size == size && to.groups[group].depth == depth)) ++group;
    if (group == to.group_count) to.groups[to.group_count++] = {kind, size, depth, 0};
    return group;
  }
  constexpr seat place(storage_kind kind, int size, int depth = 0) {
    const int group = group_of_kind(kind, size, depth);
    return {group, to.groups[group].count++};
  }

  constexpr void place_components() {
    likeness types(g.leaf_count);
    for (int l = 0; l < g.leaf_count; ++l) {
      const int first = types.first_alike(g.leaves[l].item->component->key, l, [&](int a, int b) {
        return g.leaves[a].item->component->key == g.leaves[b].item->component->key;
      });
      to.cells[l] = {first, to.cell_counts[first]++};
    }
  }

  // Each part of a beat has its own locals.
  constexpr void place_locals() {
    scratch used(2 * g.output_count);
    for (int r = 0; r < g.turn_count; ++r) {
      const auto& t = g.turns[g.order[r]];
      if (r % g.turns_in_part == 0)
        for (int group = 0; group < to.group_count; ++group) used[group] = 0;
      for (int o = t.first_output; o < t.first_output + t.half->output_count; ++o) {
        if (g.outputs[o].kept || !g.outputs[o].local) continue;
        // What is written in each beat needs no first value; of the rest g++ would warn that it may be read before.
        const bool sure = published(g, g.outputs[o]).every_beat();
        const int group = group_of_kind(sure ? storage_kind::local : storage_kind::local_if_published, port_of(g, g.outputs[o]).space->size);
        to.newest[o] = {group, used[group]++};
        if (used[group] > to.groups[group].count) to.groups[group].count = used[group];
      }
    }
  }

  constexpr void place_samples() {
    for (int o = 0; o < g.output_count; ++o) {
      const auto& out = g.outputs[o];
      const int size = port_of(g, out).space->size;
      if (out.kept) to.newest[o] = place(out.stamped ? storage_kind::kept_with_beat : storage_kind::kept, size);
      if (out.ring > 0) to.past[o] = place(storage_kind::past, size, out.ring);
    }
    for (int i = 0; i < g.input_count; ++i) {
      const auto& in = g.inputs[i];
      if (in.queue >= 0) to.sources[i] = place(storage_kind::queue, port_of(g, in).space->size, in.wire->number);
      else if (in.writer >= 0) to.sources[i] = delay_of(in) > 0 && !in.is_kept ? to.past[in.writer] : to.newest[in.writer];
    }
    for (int t = 0; t < g.turn_count; ++t) to.firings[t] = g.turns[t].fires.dynamic() ? to.firing_count++ : -1;
  }

  constexpr std::uint64_t key_of(const input& in, int source, std::uint64_t key) const {
    if (in.writer < 0) return mixed(key, -1);
    const auto c = published(g, g.outputs[in.writer]);
    for (const std::int64_t fact : {std::int64_t{source}, c.period, c.first, std::int64_t{delay_of(in)}})
      key = mixed(key, fact);
    return mixed(key, in.is_kept | in.in_beat << 1 | in.own_initial << 2 | in.counts << 3);
  }

  constexpr std::uint64_t key_of(const turn& t) const {
    std::uint64_t key = 0;
    for (const std::int64_t fact : {std::int64_t{to.cells[t.leaf].group}, static_cast<std::int64_t>(t.phase), t.fires.period, t.fires.first})
      key = mixed(key, fact);
    for (int i = t.first_input; i < t.first_input + t.half->input_count; ++i) key = key_of(g.inputs[i], to.sources[i].group, key);
    for (int o = t.first_output; o < t.first_output + t.half->output_count; ++o) {
      key = mixed(key, to.newest[o].group);
      key = mixed(key, to.past[o].group);
    }
    return key;
  }

  // Observers read, and queues are filled, by the numbers of the ports.
  constexpr bool is_special(const turn& t) const {
    for (int i = t.first_input; i < t.first_input + t.half->input_count; ++i)
      if (!port_of(g, g.inputs[i]).space) return true;
    for (int o = t.first_output; o < t.first_output + t.half->output_count; ++o)
      for (int i = g.outputs[o].first_reader; i >= 0; i = g.inputs[i].next_of_writer)
        if (g.inputs[i].queue >= 0) return true;
    return false;
  }

  static constexpr bool same_initial(ref<item_info> a, ref<item_info> b) {
    const bool given = a && a->initial;
    if (given != (b && b->initial)) return false;
    if (!given) return true;
    if (a->initial_count != b->initial_count) return false;
    for (int c = 0; c < a->initial_count; ++c)
      if (a->initial[c] != b->initial[c]) return false;
    return true;
  }

  constexpr void find_alike() {
    likeness functions(g.turn_count);
    scratch special(g.turn_count);
    for (int t = 0; t < g.turn_count; ++t) special[t] = is_special(g.turns[t]);
    for (int t = 0; t < g.turn_count; ++t)
      to.like[t] = functions.first_alike(key_of(g.turns[t]), t, [&](int x, int y) {
        const auto &a = g.turns[x], &b = g.turns[y];
        if (special[x] || special[y] || node_of(g, a).strategy_key != node_of(g, b).strategy_key || key_of(a) != key_of(b)) return false;
        for (int i = 0; i < a.half->input_count; ++i)
          if (!same_initial(g.inputs[a.first_input + i].wire, g.inputs[b.first_input + i].wire)) return false;
        return true;
      });
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
  layout<size.leaves, size.turns, size.inputs, size.outputs> result;
  auto plan = plan_of<Graph>;
  const auto view = plan.view();
  laying_out<decltype(result)>{view, result}.run();
  return result;
}();

}  // namespace cca::detail
