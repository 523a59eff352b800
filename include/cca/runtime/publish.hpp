// What a component returned goes to its readers: it stays where it is for those of this beat, and is stored
// for those of later beats and for queues, and sent to other environments.
//
// `Output` is the number of the first output that is published in the same way; `index` says where in its
// array this one is stored.
#pragma once

#include <utility>

#include <cca/runtime/inputs.hpp>

namespace cca::detail {

// The next of an output's readers, from `input` on, that has a queue; -1: none.
template <class Graph>
constexpr int queue_from(int input) {
  const auto& inputs = plan_of<Graph>.inputs;
  while (input >= 0 && !is_queued(inputs[static_cast<std::size_t>(input)]))
    input = inputs[static_cast<std::size_t>(input)].next_of_writer;
  return input;
}

// Into the queues among the readers of an output, from reader `Input` on. An output that has some has no
// twin.
template <class Graph, int Input, class Vector>
CCA_INLINE void put_into_queues(const beat_context<Graph>& b, const Vector& v, std::int64_t origin) {
  constexpr place at = layout_of<Graph>.sources[Input];
  constexpr const auto& in = input_of<Graph, Input>;
  const bool had_room = b.template at<at.array>(at.index).put(v, origin);
  if constexpr (in.wire->full == full_kind::reject) {
    if (!had_room) b.outcome = {"a sample arrived while the queue was full", call_of<Graph, in.call>.node};
  }
  constexpr int next = queue_from<Graph>(in.next_of_writer);
  if constexpr (next >= 0) put_into_queues<Graph, next>(b, v, origin);
}

// An output that a component returned.
template <class Graph, int Output, class Result>
CCA_INLINE void publish(const beat_context<Graph>& b, Result& result, int index, std::int64_t oldest) {
  constexpr const auto& out = output_of<Graph, Output>;
  if constexpr (requires { result.operator bool(); })
    if (!result) return;
  if (result.origin() == never) result.with_origin(oldest);
  const auto& coordinates = std::as_const(result).vector();
  if constexpr (out.storage == storage_kind::of_beat)
    b.template at<layout_of<Graph>.outputs[Output].array>(index).template put<out.port>();
  if constexpr (out.storage == storage_kind::newest || out.storage == storage_kind::past)
    b.template at<layout_of<Graph>.outputs[Output].array>(index).put(coordinates, result.origin(), b.k);
  if constexpr (out.leaves) b.state.template send<Output>(coordinates, result.origin(), b.k);
  constexpr int queue = queue_from<Graph>(out.first_reader);
  if constexpr (queue >= 0) put_into_queues<Graph, queue>(b, coordinates, result.origin());
}

}  // namespace cca::detail
