// What a component returned goes to its readers: it stays where it is for those of this beat, and is stored
// for those of later beats and for queues.
//
// `Output` is the number of the first output that is published in the same way; `index` says where in its
// array this one is stored.
#pragma once

#include <tuple>

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

template <class Graph, int Output, class Result>
CCA_INLINE void publish(const beat_context<Graph>& b, Result& result, int index, std::int64_t oldest) {
  constexpr const auto& out = output_of<Graph, Output>;
  if constexpr (requires { result.operator bool(); })
    if (!result) return;
  if (result.origin() == never) result.with_origin(oldest);
  if constexpr (out.storage == storage_kind::newest || out.storage == storage_kind::past)
    b.template at<layout_of<Graph>.outputs[Output].array>(index).put(std::as_const(result).vector(),
                                                                     result.origin(), b.k);
  constexpr int queue = queue_from<Graph>(out.first_reader);
  if constexpr (queue >= 0) put_into_queues<Graph, queue>(b, std::as_const(result).vector(), result.origin());
}

// One of the results of call `Call`: an output, at `Position` among them, or a fault.
template <class Graph, int Call, int Position, class Result>
CCA_INLINE void publish_one(const beat_context<Graph>& b,
                            Result& result,
                            const call_place& at,
                            std::int64_t oldest) {
  if constexpr (std::is_same_v<Result, fault>) {
    if (result) b.outcome = {result.reason(), at.node};
  } else {
    const int index = layout_of<Graph>.outputs[at.first_output + Position].index;
    publish<Graph, output_at<Graph, Call, Position>>(b, result, index, oldest);
  }
}

template <class Graph, int Call, class Result>
CCA_INLINE void publish_all(const beat_context<Graph>& b,
                            Result& result,
                            const call_place& at,
                            std::int64_t oldest) {
  publish_one<Graph, Call, 0>(b, result, at, oldest);
}
template <class Graph, int Call, class... Results, std::size_t... I>
CCA_INLINE void publish_each(const beat_context<Graph>& b,
                             std::tuple<Results...>& results,
                             const call_place& at,
                             std::int64_t oldest,
                             std::index_sequence<I...>) {
  using ports = function_ports<list<>, list<Results...>>;
  (publish_one<Graph, Call, ports::output_of_result[I]>(b, std::get<I>(results), at, oldest), ...);
}
template <class Graph, int Call, class... Results>
CCA_INLINE void publish_all(const beat_context<Graph>& b,
                            std::tuple<Results...>& results,
                            const call_place& at,
                            std::int64_t oldest) {
  publish_each<Graph, Call>(b, results, at, oldest, std::index_sequence_for<Results...>{});
}

}  // namespace cca::detail
