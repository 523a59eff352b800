// In a fast run, a fault cuts the beat of every environment where it would have cut the one loop: the
// calls after it in the order of the whole don't run. So an environment waits before a call until all calls
// in front of it that may fault, elsewhere, have gone well. It also waits for the samples that the call reads
// in the beat of their publication: wires of a free-running environment may have no delay. Into a queue that
// several of them fill they come in the order of the whole, so a call that publishes into it waits for those
// before it.
//
// Where such a sample may find a queue full that rejects it, the environment of the queue says so: it is done
// with the call that published the sample, as if it were its own, when the sample has entered.
#pragma once

#include <algorithm>
#include <array>

#include <cca/runtime/environments/exchange/exchange.hpp>

namespace cca::detail {

template <class D>
struct fault_order {
  static constexpr std::size_t calls = array_size(graph_size<D>.calls) + 1;

  // The number of a call in the order of the whole, by its number in that of its environment.
  std::array<int, calls> whole_rank{};
  // Of each other environment, before each call: how many calls of the whole must be done, if they are its
  // own; 0: none that may fault.
  std::array<std::array<int, calls>, array_size(environment_count<D>)> needed{};
  // The same after the last call of a beat.
  std::array<int, array_size(environment_count<D>)> last{};

  // Of each input with a queue that may reject what arrives when a beat begins: its rank, before all calls.
  std::array<int, array_size(input_count_of<D>) + 1> rank_of_entries{};
  int own_entries = 0;  // how many of these must be done when those of this environment are; 0: it has none

  // Of each call of the whole, where it publishes into a queue of this environment that may reject it: before
  // which own call that enters; -1: it does not.
  std::array<int, calls> enters_before{};
  // Of each call of this environment its number in the plan of the whole.
  std::array<int, calls> rank_in_plan{};
};

// Does a call publish at once into a queue of another environment that may reject it?
constexpr bool may_be_rejected_in(const flat_view& g, int call, int environment) {
  const auto& c = g.calls[call];
  for (int o = c.first_output; o < c.first_output + c.function->output_count; ++o)
    for (int i = g.outputs[o].first_reader; i >= 0; i = g.inputs[i].next_of_writer)
      if (const auto& in = g.inputs[i]; crosses_at_once(g, in) && in.wire->full == full_kind::reject &&
                                        environment_of(g, in.call) == environment)
        return true;
  return false;
}

// Does a call publish at once into a queue that another one fills at once from elsewhere, and before it? Or
// does it observe what waits there?
constexpr bool shares_queue(const flat_view& g, int from, int to) {
  const auto& c = g.calls[to];
  bool found = false;
  const auto is_filled = [&](const input& way) {
    found |= crosses_at_once(g, way) && g.outputs[way.writer].call == from;
  };
  for (int h = g.first_link; g.queue_count > 0 && h < g.input_count; ++h)
    if (const auto& in = g.inputs[h]; in.call == to && in.shows >= 0) for_each_way(g, in.shows, is_filled);
  for (int o = c.first_output; o < c.first_output + c.function->output_count; ++o)
    for (int i = g.outputs[o].first_reader; i >= 0; i = g.inputs[i].next_of_writer) {
      const auto& in = g.inputs[i];
      if (!is_merged(in) || in.delay > 0 || crosses_at_once(g, in)) continue;
      for_each_way(g, in.way_of >= 0 ? in.way_of : i, is_filled);
    }
  return found;
}

constexpr bool feeds_at_once(const flat_view& g, int from, int to) {
  const auto& c = g.calls[from];
  for (int o = c.first_output; o < c.first_output + c.function->output_count; ++o)
    if (reads_at_once(g, to, o)) return true;
  return false;
}

template <class D, int E>
inline constexpr auto fault_order_of = [] {
  fault_order<D> order;
  const auto& plan = plan_of<D>;
  const auto g = plan.view();
  std::size_t here = 0;
  int entries = 0;
  for (int& before : order.enters_before) before = -1;
  for (int i = 0; i < g.input_count; ++i) {
    if (!may_reject_entries(plan, i)) continue;
    order.rank_of_entries[array_size(i)] = entries++;
    const int environment = environment_of(g, g.inputs[i].call);
    order.last[array_size(environment)] = entries;
    if (environment == E) order.own_entries = entries;
  }
  for (int r = 0; r < g.call_count; ++r) {
    const auto& c = g.calls[g.order[r]];
    const int environment = environment_of(g, g.order[r]);
    if (environment == E) {
      order.whole_rank[here] = entries + r;
      order.rank_in_plan[here] = r;
      for (std::size_t x = 0; x < order.last.size(); ++x)
        if (x != E) order.needed[x][here] = std::max(order.last[x], here > 0 ? order.needed[x][here - 1] : 0);
      for (int w = 0; w < r; ++w)
        if (const int x = environment_of(g, g.order[w]);
            x != E && (feeds_at_once(g, g.order[w], g.order[r]) || shares_queue(g, g.order[w], g.order[r])))
          order.needed[array_size(x)][here] = std::max(order.needed[array_size(x)][here], entries + w + 1);
      ++here;
    }
    if (may_fault_in(g, c)) order.last[array_size(environment)] = entries + r + 1;
    for (int x = 0; x < placement_in(g).count; ++x)
      if (x != environment && may_be_rejected_in(g, g.order[r], x)) {
        order.last[array_size(x)] = entries + r + 1;
        if (x == E) order.enters_before[array_size(r)] = static_cast<int>(here);
      }
  }
  return order;
}();

}  // namespace cca::detail
