// What a twin does with an output: compute it anew, or be fed with it, because a resource node sensed it and
// a component reads it.
#pragma once

#include <cca/base/array_size.hpp>
#include <cca/graph/deployment/part.hpp>
#include <cca/graph/items/modes.hpp>
#include <cca/record/file/message_sink.hpp>
#include <cca/runtime/each_component.hpp>

namespace cca::recording::detail {

template <class Graph>
replay_role role_in_replay(int output) {
  using cca::detail::array_size;
  using cca::detail::phase_of_beat;
  const auto& plan = cca::detail::plan_of<Graph>;
  const auto& call = plan.calls[array_size(plan.outputs[array_size(output)].call)];
  // What free-running environments publish can't be computed anew.
  if constexpr (cca::detail::has_free_running<Graph>)
    if (cca::detail::is_free_node<Graph>(call.node)) return replay_role::fed;
  if (call.phase == phase_of_beat::process) return replay_role::computed;
  if constexpr (Modes<Graph> || cca::detail::has_free_running<Graph>) return replay_role::fed;
  for (int i = 0; i < cca::detail::counts_of<Graph>.input_count; ++i)
    if (const auto& in = plan.inputs[array_size(i)];
        in.writer == output && plan.calls[array_size(in.call)].phase == phase_of_beat::process)
      return replay_role::fed;
  return replay_role::none;
}

}  // namespace cca::recording::detail
