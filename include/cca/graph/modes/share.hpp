// All modes of a set together, as one flat graph without an order: each component once, with the outputs and
// queues that outlive a beat in any mode. A node of a mode is found by its path.
//
// A component that not all modes have, or that fires at other beats in another mode, is unsteady: its clock
// does not tell when it fired before the switch, so this is kept at run time.
#pragma once

#include <cca/graph/diagnosis/rules/check.hpp>
#include <cca/graph/modes/mode_info.hpp>
#include <cca/graph/modes/rules/list_of_modes.hpp>
#include <cca/graph/modes/same_commands.hpp>
#include <cca/graph/modes/unseen_samples.hpp>

namespace cca::detail {

struct sharing {
  flat_view to;
  name_table names;
  const modes_info& all;

  constexpr mode_view view_of(int mode) const {
    return {*all.modes[mode].plan, to, names.entries, names.mask};
  }

  constexpr void add_mode(int mode) {
    const auto& from = *all.modes[mode].plan;
    const int first_scope = to.scope_count;
    for (int s = 0; s < from.scope_count; ++s) {
      auto& added = to.scopes[to.scope_count++];
      added = from.scopes[s];
      if (added.parent >= 0) added.parent += first_scope;
    }
    for (int p = 0; p < from.part_count; ++p) join_part(mode, p, first_scope);
    for (int n = 0; n < from.node_count; ++n) {
      const auto& node = from.nodes[n];
      const auto path = path_hash(from.scopes[node.scope], node.item->from, node.item->from_hash);
      if (names.add(path, to.node_count)) add_node(mode, n, first_scope);
      else join_node(mode, n, find(names.entries, names.mask, path));
    }
  }

  // A part is one of the whole set if each mode that has its node lets it be stopped.
  constexpr void join_part(int mode, int part, int first_scope) {
    const auto& from = *all.modes[mode].plan;
    const auto& own = from.parts[part];
    for (int m = 0; m < all.count; ++m)
      if (has_other_node(*all.modes[m].plan, own.hash)) return;
    int shared = 0;
    while (shared < to.part_count && to.parts[shared].hash != own.hash) ++shared;
    if (shared == to.part_count) {
      to.parts[to.part_count++] = {.parent = find_part(from, own.parent, to),
                                   .item = own.item,
                                   .scope = own.scope + first_scope,
                                   .hash = own.hash};
    }
    to.parts[shared].members |= bit_of(mode);
  }
  // A node of this path that can't be stopped.
  static constexpr bool has_other_node(const flat_view& g, std::uint64_t path) {
    for (int p = 0; p < g.part_count; ++p)
      if (g.parts[p].hash == path) return false;
    for (int s = 1; s < g.scope_count; ++s)
      if (g.scopes[s].hash == path) return true;
    for (int n = 0; n < g.node_count; ++n)
      if (const auto& node = g.nodes[n];
          path_hash(g.scopes[node.scope], node.item->from, node.item->from_hash) == path)
        return true;
    return false;
  }
  // The part of all modes that is this one of a mode, or the next one around it; -1: none.
  static constexpr int find_part(const flat_view& mode, int part, const flat_view& whole) {
    for (; part >= 0; part = mode.parts[part].parent)
      for (int shared = 0; shared < whole.part_count; ++shared)
        if (whole.parts[shared].hash == mode.parts[part].hash) return shared;
    return -1;
  }

  constexpr void add_node(int mode, int n, int first_scope) {
    const auto& from = *all.modes[mode].plan;
    auto& added = to.nodes[to.node_count];
    added = from.nodes[n];
    added.scope += first_scope;
    added.part = find_part(from, added.part, to);
    added.first_call = to.call_count;
    added.members = bit_of(mode);
    for (int c = 0; c < added.call_count; ++c) {
      const auto& call = from.calls[from.nodes[n].first_call + c];
      auto& own = to.calls[to.call_count];
      own = call;
      own.node = to.node_count;
      own.first_input = 0;
      own.first_output = to.output_count;
      own.longest_period = call.own_clock.known() ? call.own_clock.period : 1;
      for (int p = 0; p < call.function->output_count; ++p) {
        to.outputs[to.output_count] = {};
        to.outputs[to.output_count].call = to.call_count;
        to.outputs[to.output_count++].port = p;
      }
      ++to.call_count;
    }
    ++to.node_count;
  }

  constexpr void join_node(int mode, int n, int shared) {
    const auto& from = *all.modes[mode].plan;
    auto& node = to.nodes[shared];
    check<when::shared_path>(to, {.item = from.nodes[n].item,
                                  .component = shared,
                                  .numbers = modes_at_fault(first_of(node.members), mode)});
    if (to.found.is_broken()) return;
    node.members |= bit_of(mode);
    // It can be stopped on its own if each of its modes says so.
    if (!from.nodes[n].item->is_stoppable()) node.item = from.nodes[n].item;
    for (int c = 0; c < node.call_count; ++c) {
      const auto& other = from.calls[from.nodes[n].first_call + c];
      const clock ticks = other.own_clock;
      auto& own = to.calls[node.first_call + c];
      own.may_miss |= other.may_miss;
      if (!(own.fires == other.fires && own.own_clock == ticks)) {
        own.fires = own.own_clock = dynamic_clock;
        own.other_clocks = true;
      }
      if (ticks.known() && ticks.period > own.longest_period) own.longest_period = ticks.period;
    }
  }

  constexpr void add_taken(int mode) {
    const auto view = view_of(mode);
    for (int o = view.g.output_count - view.g.taken_count; o < view.g.output_count; ++o) {
      const int shared = view.shared_output(o);
      if (shared == to.output_count) {
        to.outputs[to.output_count++] = {.call = view.shared_call(view.g.outputs[o].call),
                                         .port = view.g.outputs[o].port,
                                         .is_taken = true};
        ++to.taken_count;
      }
      to.outputs[shared].members |= bit_of(mode);
    }
  }

  // How a sample is stored is the same in all modes: as in the one that needs most.
  constexpr void join_samples(int mode) {
    const auto view = view_of(mode);
    for (int o = 0; o < view.g.output_count; ++o) {
      auto out = view.g.outputs[o];
      auto& own = to.outputs[view.shared_output(o)];
      if (out.storage == storage_kind::of_beat &&
          may_be_unseen(view, o, all.count, [this](int m) { return view_of(m); }))
        out.storage = storage_kind::newest;
      own.watched |= out.watched;
      own.leaves |= out.leaves;
      if (out.in_a_beat > own.in_a_beat) own.in_a_beat = out.in_a_beat;
      if (out.storage == storage_kind::none || out.storage == storage_kind::of_beat) continue;
      if (out.storage > own.storage) own.storage = out.storage;
      if (out.depth > own.depth) own.depth = out.depth;
      if (!own.initial_of) own.initial_of = out.initial_of;
    }
    for (int i = 0; i < view.g.input_count; ++i) {
      const auto& in = view.g.inputs[i];
      if (in.queue < 0) continue;
      if (in.way_of < 0) join_queue(view, mode, i);
      if (is_kept_way(view.g, in) && is_for_many(in)) join_way(view, mode, i);
    }
  }

  constexpr void join_queue(const mode_view& view, int mode, int i) {
    const auto& in = view.g.inputs[i];
    auto& own = to.inputs[find_queue(view, i, to)];
    if (own.queue < 0) {
      own = in;
      own.call = view.shared_call(in.call);
      own.writer = is_for_many(in) ? -1 : view.shared_output(in.writer);
      own.next_way = -1;
      if (is_for_many(in)) own.delay = 0;  // what is under way is kept for each wire
      own.queue = to.queue_count++;
      ++to.input_count;
    }
    own.members |= bit_of(mode);
    own.counts_vary |= in.counts_vary || (is_for_many(in) && in.counts != own.counts);
    own.counts_arrivals |= in.counts_arrivals;
  }
  constexpr void join_way(const mode_view& view, int mode, int i) {
    const auto& in = view.g.inputs[i];
    const int queue = find_queue(view, in.way_of >= 0 ? in.way_of : i, to);
    auto& own = to.inputs[find_way(view, i, to)];
    if (own.queue < 0) {
      own = in;
      own.call = view.shared_call(in.call);
      own.writer = view.shared_output(in.writer);
      own.next_way = -1;
      own.queue = to.inputs[queue].queue;
      own.way_of = queue;
      ++to.input_count;
    }
    own.members |= bit_of(mode);
  }

  // Several wires may lead into its queue, other ones in another mode.
  static constexpr bool is_for_many(const input& in) { return in.wire->policy == policy_kind::merged; }

  // The queue of an input among those of all modes; if there is none, the number of the next one. What a
  // program hears by several patterns has a queue for each.
  static constexpr int find_queue(const mode_view& view, int i, const flat_view& whole) {
    const auto& in = view.g.inputs[i];
    const int call = view.shared_call(in.call);
    const int writer = is_for_many(in) ? -1 : view.shared_output(in.writer);
    int earlier = 0;
    for (int other = view.g.first_link; in.outside && other < i; ++other)
      earlier += view.g.inputs[other].outside && has_equal_queue(view.g.inputs[other], in) &&
                 view.g.inputs[other].writer == in.writer;
    int q = 0;
    for (; q < whole.input_count; ++q) {
      const auto& own = whole.inputs[q];
      if (own.outside == in.outside && own.call == call && own.port == in.port && own.way_of < 0 &&
          own.writer == writer && has_equal_queue(own, in) && earlier-- == 0)
        break;
    }
    return q;
  }
  static constexpr bool has_equal_queue(const input& a, const input& b) {
    return a.queue >= 0 && b.queue >= 0 && is_for_many(a) == is_for_many(b) &&
           a.wire->capacity == b.wire->capacity && a.wire->full == b.wire->full &&
           (is_for_many(b) || a.delay == b.delay);
  }
  // The same of a delayed way into it.
  static constexpr int find_way(const mode_view& view, int i, const flat_view& whole) {
    const auto& in = view.g.inputs[i];
    if (!is_for_many(in)) return find_queue(view, i, whole);
    const int queue = find_queue(view, in.way_of >= 0 ? in.way_of : i, whole);
    const int writer = view.shared_output(in.writer);
    int w = 0;
    for (; w < whole.input_count; ++w) {
      const auto& own = whole.inputs[w];
      if (own.way_of == queue && own.writer == writer && own.delay == in.delay) break;
    }
    return w;
  }

  constexpr void check_nodes() {
    const auto everywhere = all_of_modes(all);
    for (int n = 0; n < to.node_count; ++n) {
      const auto& node = to.nodes[n];
      if (node.members == everywhere) continue;
      for (int c = node.first_call; c < node.first_call + node.call_count; ++c)
        to.calls[c].fires = to.calls[c].own_clock = dynamic_clock;
      check<when::missing_node>(
          to, {.item = node.item,
               .scope = node.scope,
               .component = n,
               .numbers = modes_at_fault(first_of(node.members), first_of(everywhere & ~node.members))});
    }
    for (int c = 0; c < to.call_count; ++c)
      for (int r = 0; r < to.calls[c].function->requested_count; ++r)
        check<when::requested_mode>(to, {.item = &item_of_call(to, to.calls[c]),
                                         .scope = scope_of_call(to, to.calls[c]),
                                         .name = to.calls[c].function->requested_modes[r]});
  }

  // What a component stops is a part in each mode that has its node.
  constexpr void check_requests() {
    for (int m = 0; m < all.count; ++m) {
      const auto& g = *all.modes[m].plan;
      for (int r = 0; r < g.request_count; ++r) {
        const auto& asking = g.calls[g.requests[r].call];
        const auto& wanted = g.parts[g.requests[r].part];
        bool is_shared = false;
        for (int p = 0; p < to.part_count; ++p) is_shared |= to.parts[p].hash == wanted.hash;
        if (!is_shared)
          check<when::unknown_part>(
              to, {.item = &item_of_call(g, asking),
                   .scope = to.nodes[view_of(m).shared_node(asking.node)].scope,
                   .name = asking.function->asked_parts[r - asking.first_request].path,
                   .why = "but not every mode that has this node lets it be stopped: give it "
                          "cca::stoppable<...> in all of them"});
      }
    }
  }

  // Each actuator, in each pair of modes.
  constexpr void check_commands() {
    for (int m = 0; m < all.count; ++m) {
      const auto one = view_of(m);
      for (int i = 0; i < one.g.first_link; ++i) {
        if (!is_actuated(one.g, one.g.inputs[i])) continue;
        for (int other = m + 1; other < all.count; ++other) check_command(one, m, i, view_of(other), other);
      }
    }
  }
  constexpr void check_command(
      const mode_view& one, int mode, int i, const mode_view& other, int other_mode) {
    const auto& in = one.g.inputs[i];
    const int call = one.shared_call(in.call);
    for (int x = 0; x < other.g.first_link; ++x) {
      const auto& there = other.g.inputs[x];
      if (there.port != in.port || other.shared_call(there.call) != call) continue;
      const auto part = find_parting(one, i, other, x);
      if (part.input < 0) continue;
      const auto &a = one.g.inputs[part.input], &b = other.g.inputs[part.other];
      const int node = to.calls[one.shared_call(a.call)].node;
      check<when::parting_commands>(
          to, {.item = to.nodes[node].item,
               .scope = to.nodes[node].scope,
               .output = one.shared_output(a.writer),
               .component = node,
               .numbers = modes_at_fault(mode, other_mode, other.shared_output(b.writer)),
               .name = port_of(one.g, a).name});
    }
  }

  constexpr void run() {
    to.hung = &all;
    check<when::stated_modes>(to, {});
    for (int m = 0; m < all.count; ++m) check<when::stated_mode>(to, {.numbers = modes_at_fault(m)});
    for (int m = 0; m < all.count; ++m)  // the mode itself says what is wrong with it
      if (!all.modes[m].plan || all.modes[m].plan->found.is_broken()) return;
    if (to.found.is_broken()) return;
    to.hz = all.modes[0].plan->hz;
    to.period = all.modes[0].plan->period;
    for (int m = 0; m < all.count && !to.found.is_broken(); ++m) {
      to.may_fault |= all.modes[m].plan->may_fault;
      check<when::known_rate_of_mode>(to, {.numbers = modes_at_fault(0, m)});
      add_mode(m);
    }
    if (to.found.is_broken()) return;
    for (int m = 0; m < all.count; ++m) add_taken(m);
    for (int m = 0; m < all.count; ++m) join_samples(m);
    check_nodes();
    if (all.is_checked) return;
    check_requests();
    check_commands();
  }
};

constexpr flat_view share(flat_view to, name_table names, const modes_info& all) {
  sharing step{to, names, all};
  step.run();
  return step.to;
}

}  // namespace cca::detail
