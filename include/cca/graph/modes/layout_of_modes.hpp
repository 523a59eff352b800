// Where the components and samples of a set of modes lie. All modes use the same memory; only the results
// that end with a beat are each mode's own.
#pragma once

#include <cca/graph/layout/layout.hpp>
#include <cca/graph/modes/plan_of_modes.hpp>

namespace cca::detail {

template <Modes M>
inline constexpr auto layout_of<M> = [] {
  constexpr auto& size = graph_size<M>;
  layout<size.nodes, size.calls, input_count_of<M>, output_room_of<M>> result;
  layout_step<decltype(result)> step{shown_plan<M>, result};
  step.place_nowhere();
  step.place_components();
  step.place_samples();
  step.place_calls();
  return result;
}();

// The places of a mode are those of all modes.
template <ModeKey Mode>
inline constexpr auto layout_of<Mode> = [] {
  using M = set_of_key<Mode>;
  constexpr auto& size = graph_size<Mode>;
  layout<size.nodes, size.calls, input_count_of<Mode>, output_room_of<Mode>> result;
  const auto& plan = plan_of<Mode>;
  const auto g = plan.view();
  layout_step<decltype(result)>{g, result}.run();

  const auto& whole = layout_of<M>;
  const auto view = shared_plan_of<M>.view_of(g, shown_plan<M>);
  for (int n = 0; n < g.node_count; ++n)
    result.components[n].index = whole.components[view.shared_node(n)].index;
  result.firing_count = whole.firing_count;  // also of functions whose clock is known in this mode
  result.missed_count = whole.missed_count;
  for (int c = 0; c < g.call_count; ++c) {
    result.calls[c].component = result.components[g.calls[c].node].index;
    result.calls[c].firing = whole.calls[view.shared_call(c)].firing;
    result.calls[c].missed = whole.calls[view.shared_call(c)].missed;
  }
  for (int o = 0; o < g.output_count; ++o)
    if (const int shared = view.shared_output(o); view.whole.outputs[shared].storage != storage_kind::none)
      result.outputs[o].index = whole.outputs[shared].index;
  for (int i = 0; i < g.input_count; ++i)
    if (const auto& in = g.inputs[i]; g.calls[in.call].elsewhere) {
      continue;
    } else if (in.queue >= 0) {
      const int head = in.way_of >= 0 ? in.way_of : i;
      result.sources[i].index = whole.sources[sharing::find_queue(view, head, view.whole)].index;
      if (is_on_the_way(in) && result.on_the_way[i].array >= 0)
        result.on_the_way[i].index = whole.on_the_way[sharing::find_way(view, i, view.whole)].index;
    } else if (in.shows >= 0) {
      result.sources[i] = result.sources[in.shows];
    } else if (in.writer >= 0 && !layout_step<decltype(result)>{g, result}.reads_result(in)) {
      result.sources[i] = result.outputs[in.writer];
    }
  return result;
}();

// The array of all modes that is this one of a mode.
template <class M, int I, int Array>
inline constexpr int shared_array = [] {
  int array = 0;
  while (!layout_of<M>.arrays[array].stores_like(layout_of<mode_key<M, I>>.arrays[Array])) ++array;
  return array;
}();

}  // namespace cca::detail
