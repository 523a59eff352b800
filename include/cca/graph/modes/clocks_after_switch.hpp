// Which clocks hold in a set of modes. The clock of a strategy that fires when samples arrive follows from
// those of its inputs, as if they had been so since beat 0. After a switch that holds
//
//   - for a component that all modes have, with one clock, if the same is true of all that it looks at;
//   - if a sample arrives in each beat, or in none: then what came before does not matter.
//
// Any other is open: it is asked at run time, so it fires as its strategy says. The clock of `timed<N>` and
// of all that do not look at inputs holds always, but for `timeout<N>`, which counts from the last firing.
//
// Cost: an open component keeps its last firing, and tests in each beat whether its inputs are fresh.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <cca/graph/plan/arrivals.hpp>
#include <cca/graph/modes/mode_info.hpp>
#include <cca/graph/plan/names.hpp>
#include <cca/graph/plan/scratch.hpp>
#include <cca/graph/planning/steps/clocks.hpp>
#include <cca/graph/planning/steps/storage.hpp>

namespace cca::detail {

class clocks_after_switch {
public:
  constexpr clocks_after_switch(const modes_info& set, int in_mode)
      : all(set),
        g(*set.modes[in_mode].plan),
        first(*set.modes[0].plan),
        mode(in_mode),
        of_first(set.count * first.call_count, -1),
        in_first(most_calls(set) * set.count, -1),
        always(first.call_count),
        holds_here(g.call_count) {
    find_calls();
    find_always();
    for (int r = 0; r < g.order_count; ++r) holds_here[g.order[r]] = find_holds(g.order[r]);
  }

  constexpr bool is_open(int call) const { return !g.calls[call].own_clock.dynamic() && !holds_here[call]; }

private:
  static constexpr int most_calls(const modes_info& set) {
    int most = 0;
    for (int m = 0; m < set.count; ++m) most = std::max(most, set.modes[m].plan->call_count);
    return most;
  }
  constexpr const flat_view& plan(int m) const { return *all.modes[m].plan; }

  // The same calls in the first mode and in another one; -1: it lacks them.
  constexpr int call_of_first(int m, int call) const { return of_first[m * first.call_count + call]; }
  constexpr int call_in_first(int m, int call) const { return in_first[call * all.count + m]; }
  constexpr void find_calls() {
    const std::uint64_t size = table_size(first.node_count);
    scratch_of<table_entry> entries(static_cast<int>(size));
    name_table names{&entries[0], size - 1};
    for (int n = 0; n < first.node_count; ++n) names.insert(path_of(first, n), n);
    for (int m = 0; m < all.count; ++m)
      for (int n = 0; n < plan(m).node_count; ++n) {
        const int same = find(names.entries, names.mask, path_of(plan(m), n));
        if (same < 0) continue;
        const auto &one = first.nodes[same], &other = plan(m).nodes[n];
        for (int c = 0; c < one.call_count && c < other.call_count; ++c) {
          of_first[m * first.call_count + one.first_call + c] = other.first_call + c;
          in_first[(other.first_call + c) * all.count + m] = one.first_call + c;
        }
      }
  }
  static constexpr std::uint64_t path_of(const flat_view& in, int node) {
    const auto& n = in.nodes[node];
    return path_hash(in.scopes[n.scope], n.item->from, n.item->from_hash);
  }
  static constexpr std::uint64_t part_of(const flat_view& in, int call) {
    const int part = part_of_call(in, call);
    return part < 0 ? 0 : in.parts[part].hash;
  }

  // Its clock is that of its strategy alone.
  static constexpr bool looks_at_no_input(const flat_view& in, int call) {
    const auto& strategy = strategy_of_call(in, in.calls[call]);
    return !strategy.has_clock_from && !strategy.in_combination.dynamic();
  }
  static constexpr bool looks_at(const strategy_info& strategy, std::string_view port) {
    return strategy.named_inputs.count == 0 || strategy.named_inputs.has(port);
  }

  // By the numbers of the first mode: in all modes, with one clock, and fed by such calls only.
  constexpr void find_always() {
    for (int c = 0; c < first.call_count; ++c) always[c] = has_one_clock(c);
    for (bool is_done = false; !is_done;) {
      is_done = true;
      for (int c = 0; c < first.call_count; ++c)
        if (always[c] && !is_fed_always(c)) always[c] = is_done = false;
    }
  }
  constexpr bool has_one_clock(int call) const {
    for (int m = 0; m < all.count; ++m) {
      const int c = call_of_first(m, call);
      if (c < 0) return false;
      const auto& one = plan(m).calls[c];
      if (one.own_clock.dynamic() || !(one.own_clock == first.calls[call].own_clock) ||
          !(one.fires == first.calls[call].fires) || part_of(plan(m), c) != part_of(first, call))
        return false;
    }
    return true;
  }
  constexpr bool is_fed_always(int call) const {
    for (int m = 0; m < all.count; ++m) {
      const auto& in = plan(m);
      const int c = call_of_first(m, call);
      const auto& t = in.calls[c];
      const auto& strategy = strategy_of_call(in, t);
      for (int i = t.first_input; strategy.has_clock_from && i < t.first_input + t.function->input_count; ++i)
        if (const auto& one = in.inputs[i]; one.wired && looks_at(strategy, port_of(in, one).name)) {
          if (is_queued(one) || is_merged(one) || !port_of(in, one).space) return false;
          if (one.writer >= 0 && !is_always(m, in.outputs[one.writer].call)) return false;
        }
    }
    return true;
  }
  constexpr bool is_always(int m, int call) const {
    const int same = call_in_first(m, call);
    return same >= 0 && always[same];
  }

  // In this mode, of which the calls before have been decided.
  constexpr bool find_holds(int call) const {
    const auto& t = g.calls[call];
    if (t.own_clock.dynamic()) return false;
    if (looks_at_no_input(g, call) || is_always(mode, call)) return true;
    const auto& strategy = strategy_of_call(g, t);
    if (!strategy.has_clock_from) return false;
    scratch_of<arrival> list(t.function->input_count);
    int count = 0;
    for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i)
      if (const auto& in = g.inputs[i]; in.wired)
        list[count++] = {port_of(g, in).name, arrives(in), is_queued(in), !port_of(g, in).space};
    const clock found = strategy.clock_from(arrivals{&list[0], count});
    return found == t.own_clock && (found.never() || found.period == 1);
  }
  // In each beat, or in none; else it is open.
  constexpr clock arrives(const input& in) const {
    const clock when = arrival_clock(g, in);
    if (in.writer < 0) return when;
    if (is_queued(in) || is_merged(in) || when.period != 1) return dynamic_clock;
    const int writer = g.outputs[in.writer].call;
    return (in.delay > 0 ? is_always(mode, writer) : holds_here[writer]) ? when : dynamic_clock;
  }

  const modes_info& all;
  const flat_view& g;      // of the mode
  const flat_view& first;  // of the first one
  int mode;
  scratch of_first, in_first;
  scratch_of<bool> always, holds_here;
};

// The plan of a mode, whose clocks are those that hold in its set.
constexpr flat_view settle_clocks(flat_view g, int mode, const modes_info& all) {
  for (int m = 0; m < all.count; ++m)
    if (!all.modes[m].plan || all.modes[m].plan->found.is_broken()) return g;
  const clocks_after_switch clocks(all, mode);
  bool any = false;
  for (int c = 0; c < g.call_count; ++c) any |= g.calls[c].open_clock = clocks.is_open(c);
  if (!any) return g;
  forget_storage(g);
  return choose_storage(find_clocks(g));
}

}  // namespace cca::detail
