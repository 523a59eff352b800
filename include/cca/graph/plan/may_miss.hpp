// Which functions may miss a firing: a fault may end a beat before their turn, and one of several
// loops may also leave out beats. If their clock is known, it does not tell when they fired last
// (runtime/samples/missed_firings.hpp).
#pragma once

#include <cca/graph/plan/flat.hpp>

namespace cca::detail {

// A function may state a fault, or fill a queue that rejects.
constexpr bool may_fault_in(const flat_view& g, const call& c) {
  if (c.function->may_fault) return true;
  for (int o = c.first_output; o < c.first_output + c.function->output_count; ++o)
    for (int i = g.outputs[o].first_reader; i >= 0; i = g.inputs[i].next_of_writer)
      if (const auto& in = g.inputs[i]; in.queue >= 0 && in.delay == 0 && in.wire->full == full_kind::reject)
        return true;
  return false;
}
// When a beat begins, something may arrive at a queue that rejects it.
constexpr bool may_fault_at_begin(const input& way) {
  return is_on_the_way(way) && way.wire->full == full_kind::reject;
}

// Of the part that one of several loops runs, where it is called twice, also those whose clock only the whole
// knows.
constexpr void find_missing(flat_view& g) {
  bool may_have_ended = g.is_spread;
  for (int i = 0; i < g.input_count; ++i) may_have_ended |= may_fault_at_begin(g.inputs[i]);
  for (int c = 0; c < g.call_count; ++c) g.calls[c].may_miss &= g.is_spread && !g.calls[c].elsewhere;
  if (!g.may_fault && !g.is_spread) return;
  for (int r = 0; r < g.order_count; ++r) {
    auto& c = g.calls[g.order[r]];
    c.may_miss |= may_have_ended && c.own_clock.known() && !c.own_clock.never();
    may_have_ended |= may_fault_in(g, c);
  }
}

}  // namespace cca::detail
