// A beat that a fault cuts, or that an environment skips, counts as done: an output whose clock is known
// counts as published in it, with its last sample. The readers of later beats rely on that clock.
#pragma once

#include <cca/runtime/state.hpp>

namespace cca::detail {

template <class Graph>
struct is_kept_by_clock {
  static constexpr bool holds(std::size_t o) {
    const auto& plan = plan_of<Graph>;
    const auto& out = plan.outputs[o];
    const bool is_kept =
        out.storage == storage_kind::past || (out.storage == storage_kind::newest && !out.by_clock);
    return is_kept && published(plan.view(), out).known();
  }
};

template <class Graph, int Output>
void repeat_output(controller_state<Graph>& state, std::int64_t k) {
  constexpr place at = layout_of<Graph>.outputs[Output];
  if (output_of<Graph, Output>.by_clock || ticks(published_of<Graph, Output>, k))
    sample_in<Graph, at.array>(state, at.index).repeat(k);
}

// What should have been published in beat k and was not.
template <class Graph>
void repeat_outputs([[maybe_unused]] controller_state<Graph>& state, [[maybe_unused]] std::int64_t k) {
  [&]<int... Output>(std::integer_sequence<int, Output...>) {
    const int all[] = {0, (repeat_output<Graph, Output>(state, k), 0)...};
    (void)all;
  }(chosen<counts_of<Graph>.output_count, is_kept_by_clock<Graph>>{});
}

}  // namespace cca::detail
