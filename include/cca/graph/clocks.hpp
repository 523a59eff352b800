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

  constexpr clock arrival_clock(const input& i) const {
    if (i.writer < 0) return port_of(g, i).space ? never_clock : dynamic_clock;
    return shifted(published(g, g.outputs[i.writer]), i.delay);
  }

  // The wired inputs of a function, as its strategy sees them.
  constexpr arrivals arrivals_of(const call& t, scratch_of<arrival>& list) const {
    int count = 0;
    for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i)
      if (const auto& in = g.inputs[i]; in.wired)
        list[count++] = {port_of(g, in).name, arrival_clock(in), in.queue >= 0};
    return {&list[0], count};
  }

  constexpr clock clock_from_arrivals(const call& t) const {
    const auto& strategy = strategy_of_call(g, t);
    if (!strategy.has_clock_from) return strategy.alone;
    scratch_of<arrival> list(t.function->input_count);
    return strategy.clock_from(arrivals_of(t, list));
  }

  constexpr bool waits_in_vain(const call& t, const strategy_info& strategy) const {
    if (!strategy.waits_for_inputs) return false;
    scratch_of<arrival> list(t.function->input_count);
    return strategy.waits_in_vain(arrivals_of(t, list));
  }

  constexpr void check_strategy(int call_index) {
    const auto& t = g.calls[call_index];
    const auto& strategy = strategy_of_call(g, t);
    if (find_part(strategy, [](const strategy_info& s) { return !s.mistake.empty(); }))
      return refuse(rule::strategy_never_fires, &item_of_call(g, t), scope_of(call_index), call_index, 2);
    if (waits_in_vain(t, strategy))
      refuse(rule::strategy_never_fires, &item_of_call(g, t), scope_of(call_index), call_index, 0);
    if (find_part(strategy, [](const strategy_info& s) { return s.excludes_itself; }))
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
    for (int t = 0; t < g.call_count; ++t) g.calls[t].fires = strategy_of_call(g, g.calls[t]).alone;
    for (int r = 0; r < g.call_count; ++r) {
      auto& t = g.calls[g.order[r]];
      if (t.fires.dynamic()) t.fires = clock_from_arrivals(t);
    }
    check_rates();
  }
};

}  // namespace cca::detail
