// Fourth step: the rate of the graph, and the clock of each function, in the order of the beat. Checks rates,
// strategies that never fire and queues that overflow.
#pragma once

#include <cca/graph/order.hpp>

namespace cca::detail {

struct clocking {
  flat_view g;

  constexpr void refuse(rule broken, const item_info* item, int scope, int a = -1, int b = -1) {
    if (g.found.broken == rule::none) g.found = {broken, a, b, -1, item, scope};
  }
  constexpr int scope_of(int call_index) const { return g.nodes[g.calls[call_index].node].scope; }

  // From the outermost graph, or else from the fastest of its spaces.
  constexpr void find_rate() {
    for (int s = 0; s < g.scope_count; ++s)
      for (int i = 0; i < g.scopes[s].graph->count; ++i) {
        const auto& item = g.scopes[s].graph->items[i];
        if (item.kind != item_kind::rate || s > 0) continue;
        if (g.hz > 0 && item.hz != g.hz) return refuse(rule::rate_mismatch, &item, 0);
        g.hz = item.hz;
      }
    if (g.hz == 0) {
      for (int i = 0; i < g.input_count; ++i)
        if (const auto space = port_of(g, g.inputs[i]).space; space && space->hz > g.hz) g.hz = space->hz;
      for (int o = 0; o < g.output_count; ++o)
        if (const auto space = port_of(g, g.outputs[o]).space; space->hz > g.hz) g.hz = space->hz;
    }
    if (g.hz == 0 || g.hz > 1e9) return refuse(rule::rate_missing, nullptr, 0);
    g.period = static_cast<std::int64_t>(1e9 / g.hz);
    for (int s = 1; s < g.scope_count; ++s)
      for (int i = 0; i < g.scopes[s].graph->count; ++i) {
        const auto& item = g.scopes[s].graph->items[i];
        if (item.kind == item_kind::rate && item.hz != g.hz) refuse(rule::rate_mismatch, &item, s);
      }
  }

  constexpr int wired_inputs(const call& t) const {
    int count = 0;
    for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i) count += g.inputs[i].wired;
    return count;
  }

  constexpr clock arrivals(const input& i) const {
    if (i.writer < 0) return port_of(g, i).space ? never_clock : dynamic_clock;
    return shifted(published(g, g.outputs[i.writer]), i.delay);
  }

  // Fires when any of the inputs is fresh; an input's samples wait, so it suffices to look at arrivals.
  constexpr clock of_any(const call& t, const strategy_info& strategy) const {
    clock any = never_clock;
    bool queued = false, all_equal = true, first = true;
    for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i) {
      const auto& in = g.inputs[i];
      if (!in.wired) continue;
      if (strategy.kind == strategy_kind::port_triggered) {
        bool named = false;
        for (int n = 0; n < strategy.count; ++n) named |= strategy.names[n] == port_of(g, in).name;
        if (!named) continue;
      }
      const auto arrival = arrivals(in);
      if (arrival.every_beat() && in.queue < 0) return arrival;
      all_equal &= first || arrival == any;
      any = first ? arrival : union_of(any, arrival);
      queued |= in.queue >= 0;
      first = false;
    }
    return queued && !all_equal ? dynamic_clock : any;
  }

  // Fires when all inputs are fresh. With the slowest input last in its first round, it fires with that one.
  constexpr clock of_all(const call& t) const {
    clock slowest = never_clock;
    bool queued = false, all_equal = true, known = true;
    std::int64_t last_start = 0;
    for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i) {
      if (!g.inputs[i].wired) continue;
      const auto arrival = arrivals(g.inputs[i]);
      if (arrival.never()) return never_clock;
      known &= arrival.known();
      if (slowest.known()) all_equal &= arrival == slowest;
      queued |= g.inputs[i].queue >= 0;
      last_start = arrival.first > last_start ? arrival.first : last_start;
      if (arrival.period > slowest.period ||
          (arrival.period == slowest.period && arrival.first > slowest.first))
        slowest = arrival;
    }
    return known && slowest.first == last_start && (!queued || all_equal) ? slowest : dynamic_clock;
  }

  constexpr clock of_strategy(const call& t) const {
    const auto& strategy = strategy_of_call(g, t);
    switch (strategy.kind) {
      case strategy_kind::restless:
      case strategy_kind::port_triggered:
        return of_any(t, strategy);
      case strategy_kind::moderate:
        return of_all(t);
      default:
        return clock_of_strategy(strategy);
    }
  }

  // It fires only when an input has arrived, and none of those that it looks at ever will.
  constexpr bool waits_in_vain(const call& t, const strategy_info& strategy) const {
    int vain = 0;
    switch (strategy.kind) {
      case strategy_kind::restless:
      case strategy_kind::moderate:
      case strategy_kind::coordinated:
        return wired_inputs(t) == 0;
      case strategy_kind::port_triggered:
        for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i)
          for (int n = 0; n < strategy.count; ++n)
            if (g.inputs[i].wired && strategy.names[n] == port_of(g, g.inputs[i]).name) return false;
        return true;
      case strategy_kind::any_of:
      case strategy_kind::all_of:
        for (int i = 0; i < strategy.count; ++i) vain += waits_in_vain(t, *strategy.parts[i]);
        return vain > 0 && (strategy.kind == strategy_kind::all_of || vain == strategy.count);
      default:
        return false;
    }
  }

  constexpr void check_strategy(int call_index) {
    const auto& t = g.calls[call_index];
    const auto& strategy = strategy_of_call(g, t);
    if (counts_no_beats(strategy))
      return refuse(rule::strategy_never_fires, &item_of_call(g, t), scope_of(call_index), call_index, 2);
    if (waits_in_vain(t, strategy))
      refuse(rule::strategy_never_fires, &item_of_call(g, t), scope_of(call_index), call_index, 0);
    if (excludes_itself(strategy))
      refuse(rule::strategy_never_fires, &item_of_call(g, t), scope_of(call_index), call_index, 1);
  }

  // A sample arrives while so many wait: it is filled faster than it is read, or full before it is read at
  // all.
  static constexpr bool overflows(clock from, clock to, std::int64_t room) {
    if (!from.known() || to.dynamic()) return false;
    return to.never() || from.period < to.period || from.first + room * from.period <= to.first;
  }

  constexpr void check_rates() {
    for (int o = 0; o < g.output_count; ++o) {
      const auto c = published(g, g.outputs[o]);
      const auto space = port_of(g, g.outputs[o]).space;
      if (c.known() && space->hz > 0 && space->hz * static_cast<double>(c.period) != g.hz)
        refuse(rule::rate_mismatch, &item_of_call(g, g.calls[g.outputs[o].call]), scope_of(g.outputs[o].call),
               o, 1);
    }
    for (int i = 0; i < g.input_count; ++i) {
      const auto& in = g.inputs[i];
      if (in.writer < 0) continue;
      const auto from = published(g, g.outputs[in.writer]), to = g.calls[in.call].fires;
      if (in.wire->policy == policy_kind::unstated && differ(from, to))
        refuse(rule::rate_unstated, in.wire, scope_of(in.call), in.writer, i);
      if (in.wire->policy == policy_kind::queue && in.wire->full == full_kind::reject &&
          overflows(from, to, in.wire->number))
        refuse(rule::queue_overflow, in.wire, scope_of(in.call), in.writer, i);
    }
  }

  constexpr void run() {
    for (int t = 0; t < g.call_count; ++t)
      g.calls[t].fires = clock_of_strategy(strategy_of_call(g, g.calls[t]));
    for (int r = 0; r < g.call_count; ++r) {
      auto& t = g.calls[g.order[r]];
      if (t.fires.dynamic()) t.fires = of_strategy(t);
    }
    check_rates();
  }
};

constexpr bool uses_coordination(const strategy_info& strategy) {
  if (strategy.kind == strategy_kind::coordinated) return true;
  for (int i = 0; is_combined(strategy) && i < strategy.count; ++i)
    if (uses_coordination(*strategy.parts[i])) return true;
  return false;
}

}  // namespace cca::detail
