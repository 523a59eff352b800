// In a fast run, a fault cuts the beat of every environment where it would have cut the one loop: the
// calls after it in the order of the whole don't run. So an environment waits before a call until all calls
// in front of it that may fault, elsewhere, have gone well. It also waits for the samples that the call reads
// in the beat of their publication: wires of a free-running environment may have no delay.
#pragma once

#include <algorithm>
#include <array>

#include <cca/runtime/environments/exchange.hpp>

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
};

constexpr bool feeds_at_once(const flat_view& g, int from, int to) {
  const auto& c = g.calls[from];
  for (int o = c.first_output; o < c.first_output + c.function->output_count; ++o)
    if (reads_at_once(g, to, o)) return true;
  return false;
}

template <class D, int E>
inline constexpr auto fault_order_of = [] {
  fault_order<D> order;
  auto plan = plan_of<D>;
  const auto g = plan.view();
  std::size_t here = 0;
  int entries = 0;
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
      for (std::size_t x = 0; x < order.last.size(); ++x)
        if (x != E) order.needed[x][here] = std::max(order.last[x], here > 0 ? order.needed[x][here - 1] : 0);
      for (int w = 0; w < r; ++w)
        if (const int x = environment_of(g, g.order[w]); x != E && feeds_at_once(g, g.order[w], g.order[r]))
          order.needed[array_size(x)][here] = std::max(order.needed[array_size(x)][here], entries + w + 1);
      ++here;
    }
    if (may_fault_in(g, c)) order.last[array_size(environment)] = entries + r + 1;
  }
  return order;
}();

}  // namespace cca::detail
