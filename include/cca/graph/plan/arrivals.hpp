// When samples arrive at the inputs of a function, as its strategy sees it.
#pragma once

#include <cca/graph/plan/flat.hpp>
#include <cca/graph/plan/scratch.hpp>

namespace cca::detail {

// More may arrive than is read: then it is fresh in other beats, too.
constexpr clock clock_of_merged(const flat_view& g, const input& i) {
  bool is_silent = true;
  for (const input* way = &i;; way = &g.inputs[way->next_way]) {
    is_silent &= published(g, g.outputs[way->writer]).never();
    if (way->next_way < 0) return is_silent ? never_clock : dynamic_clock;
  }
}

constexpr clock arrival_clock(const flat_view& g, const input& i) {
  if (i.writer < 0) return port_of(g, i).space ? never_clock : dynamic_clock;
  if (i.next_way >= 0) return clock_of_merged(g, i);
  // What arrives later than it was published may have been published before its part was stopped.
  const auto& from = g.outputs[i.writer];
  return shifted(i.delay > 0 ? published(g, from) : published_to(g, from, i.call), i.delay);
}

// Calls f with the arrivals at all wired inputs.
template <class F>
constexpr auto with_arrivals(const flat_view& g, const call& t, F f) {
  scratch_of<arrival> list(t.function->input_count);
  int count = 0;
  for (int i = t.first_input; i < t.first_input + t.function->input_count; ++i)
    if (const auto& in = g.inputs[i]; in.wired)
      list[count++] = {port_of(g, in).name, arrival_clock(g, in), is_queued(in), !port_of(g, in).space};
  return f(arrivals{&list[0], count});
}

constexpr bool waits_in_vain(const flat_view& g, const call& t) {
  const auto& strategy = strategy_of_call(g, t);
  return strategy.waits_for_inputs &&
         with_arrivals(g, t, [&](const arrivals& inputs) { return strategy.waits_in_vain(inputs); });
}

}  // namespace cca::detail
