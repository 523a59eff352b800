// Step 6, find the clocks: when each function fires and each output is published, in the order of the beat.
#pragma once

#include <cca/graph/diagnosis/rules/check.hpp>
#include <cca/graph/plan/arrivals.hpp>
#include <cca/graph/plan/may_miss.hpp>

namespace cca::detail {

constexpr clock clock_of(const flat_view& g, const call& t) {
  const auto& strategy = strategy_of_call(g, t);
  if (!strategy.has_clock_from) return strategy.alone;
  return with_arrivals(g, t, [&](const arrivals& inputs) { return strategy.clock_from(inputs); });
}

// The clock of a function of a part, while that is started. When it starts again nothing that has arrived is
// fresh, and it has not fired: so only a clock counts that depends on no earlier beat.
constexpr clock clock_in_part(const flat_view& g, const call& t) {
  const auto& strategy = strategy_of_call(g, t);
  if (!strategy.has_clock_from) return strategy.in_combination;
  if (!strategy.fires_on_arrival || strategy.part_count > 0) return dynamic_clock;
  return with_arrivals(g, t, [&](const arrivals& inputs) {
    const clock found = strategy.clock_from(inputs);
    if (found.every_beat()) return found;
    clock slower{};
    for (const auto& one : inputs) {
      if (one.queued) return dynamic_clock;  // what waits is fresh after all
      if (!one.when.known() || one.when.every_beat()) continue;
      if (slower.known() && !(slower == one.when)) return dynamic_clock;
      slower = one.when;
    }
    return found;
  });
}

// At run time, whatever its clock would be.
constexpr bool is_asked(const call& t) { return t.irregular || t.open_clock; }

constexpr flat_view find_clocks(flat_view g) {
  // First the clocks that depend on no arrivals: a delayed wire may lead back to an earlier function.
  // What another loop publishes may come late, and what has no beat at any time.
  const auto set = [&](int c, clock found) {
    auto& t = g.calls[c];
    t.own_clock = found;
    t.fires = part_of_call(g, c) >= 0 && found.known() ? dynamic_clock : found;
  };
  for (int t = 0; t < g.call_count; ++t) {
    const auto& strategy = strategy_of_call(g, g.calls[t]);
    set(t, g.calls[t].elsewhere || is_asked(g.calls[t]) ? dynamic_clock
           : part_of_call(g, t) >= 0                    ? strategy.in_combination
                                                        : strategy.alone);
  }
  for (int r = 0; r < g.order_count; ++r) {
    const int c = g.order[r];
    const auto& t = g.calls[c];
    if (t.own_clock.dynamic() && !is_asked(t))
      set(c, part_of_call(g, c) >= 0 ? clock_in_part(g, t) : clock_of(g, t));
  }

  find_missing(g);

  for (int o = 0; o < g.output_count; ++o) {
    if (g.outputs[o].is_taken) continue;  // a wire brought it here, from an output of this rate
    const auto& t = g.calls[g.outputs[o].call];
    check<when::clocked_output>(g, {.item = &item_of_call(g, t), .scope = scope_of_call(g, t), .output = o});
  }
  for (int i = 0; i < g.input_count; ++i) {
    const auto& in = g.inputs[i];
    if (in.writer >= 0 && !in.outside && (i < g.first_link || in.queue >= 0))
      check<when::clocked_wire>(
          g, {.item = in.wire, .scope = scope_of_call(g, g.calls[in.call]), .input = i, .output = in.writer});
  }
  return g;
}

}  // namespace cca::detail
