// What a component returned goes to its readers: it stays where it is for those of this beat, and is stored
// for those of later beats and for queues, and sent to other environments.
//
// A fault, a request for another mode or to stop or start a part, and `done` are results, too.
#pragma once

#include <utility>

#include <cca/graph/marks/recordable.hpp>
#include <cca/runtime/queue_entries.hpp>
#include <cca/runtime/inputs.hpp>
#include <cca/runtime/observers/tell_recorder.hpp>

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
  constexpr const auto& in = input_of<Graph, Input>;
  if constexpr (in.delay > 0) {
    constexpr place at = layout_of<Graph>.on_the_way[Input];
    if constexpr (at.array >= 0) b.template at<at.array>(at.index).put(v, origin, b.k);
  } else if constexpr (!call_of<Graph, in.call>.elsewhere) {
    put_into_queue<Graph, Input>(b.state, b.outcome, v, origin, b.k);
  }
  constexpr int next = queue_from<Graph>(in.next_of_writer);
  if constexpr (next >= 0) put_into_queues<Graph, next>(b, v, origin);
}

// The same in a replay, where more than one sample of this beat was recorded
// (record/replay/played_samples.hpp).
template <class Graph, int Output, int Input, class Vector>
void play_into_queues(const beat_context<Graph>& b, const Vector& v, std::int64_t origin);

// What a component takes from the queue of an input is told to those that observe it later, by an output
// that has no port (graph/planning/steps/listen.hpp); -1: nobody does.
template <class Graph, int Call, int Position>
inline constexpr int output_of_taken = [] {
  if (!call_of<Graph, Call>.tells_taken) return -1;
  for (int o = counts_of<Graph>.output_count - counts_of<Graph>.taken_count;
       o < counts_of<Graph>.output_count; ++o)
    if (const auto& out = plan_of<Graph>.outputs[array_size(o)]; out.call == Call && out.port == Position)
      return o;
  return -1;
}();
// In a replay of a free-running environment that is what was recorded (record/replay/played_samples.hpp).
template <class Graph, int Output>
struct played_taken {
  static constexpr bool is_told(const auto&) { return false; }
};

template <class Graph, int Output, class Vector>
CCA_INLINE void publish_taken(const beat_context<Graph>& b, const Vector& v, std::int64_t origin) {
  constexpr place at = layout_of<Graph>.outputs[Output];
  constexpr const auto& out = output_of<Graph, Output>;
  if constexpr (at.array >= 0) b.template at<at.array>(at.index).put(v, origin, b.k);
  if constexpr (out.leaves) b.state.template send<Output>(v, origin, b.k);
  if constexpr (is_probed<Graph>) tell_recorder<Graph>(b.frame, Output, v, origin);
}

// The part that a result of a call stops or starts.
template <class Graph, int Call, class Returned>
inline constexpr int asked_part_of = [] {
  const call& c = call_of<Graph, Call>;
  constexpr asked_part asked = result_facts<Returned>::asked;
  for (int r = 0; r < c.function->asked_count; ++r)
    if (c.function->asked_parts[r].path == asked.path && c.function->asked_parts[r].starts == asked.starts)
      return plan_of<Graph>.requests[array_size(c.first_request + r)].part;
  return -1;
}();

// The place of a call in the order of a beat, from 1 on; of an environment in that of the whole.
template <class Graph, int Call>
inline constexpr int place_in_beat = 1 + call_of<Graph, Call>.rank;
template <class Graph, int Call>
inline constexpr int place_in_beat<probed<Graph>, Call> = place_in_beat<Graph, Call>;

// One thing that a component returned: an output goes to its readers. `Port` is its number among the outputs.
template <class Graph, int Call, int Port, class Returned>
CCA_INLINE void publish(const beat_context<Graph>& b,
                        [[maybe_unused]] const call_place& at,
                        Returned& returned,
                        [[maybe_unused]] std::int64_t oldest) {
  if constexpr (std::is_same_v<Returned, fault>) {
    if (returned) b.outcome = {returned.reason(), at.node};
  } else if constexpr (is_mode_request<Returned>) {
    if constexpr (requires { b.state.request(returned, 0); })
      if (returned) b.state.request(returned, place_in_beat<Graph, Call>);
  } else if constexpr (std::is_same_v<Returned, done>) {
    constexpr int part = part_of_call_at<Graph, Call>;
    if (returned) b.state.parts[array_size(part)].is_stopped = b.state.parts[array_size(part)].rests = true;
  } else if constexpr (is_part_request<Returned>) {
    constexpr int part = asked_part_of<Graph, Call, Returned>;
    constexpr int place = place_in_beat<Graph, Call>;
    if (returned) {
      b.state.parts[array_size(part)].asked = result_facts<Returned>::asked.starts ? place : -place;
      b.state.is_asked = true;
    }
  } else {
    // All twins publish like the first, each at its place.
    constexpr int output = layout_of<Graph>.output_twin[call_of<Graph, Call>.first_output + Port];
    constexpr int array = layout_of<Graph>.outputs[output].array;
    constexpr const auto& out = output_of<Graph, output>;
    if constexpr (requires { returned.operator bool(); })
      if (!returned) return;
    if (returned.origin() == never) returned.with_origin(oldest);
    const auto& coordinates = std::as_const(returned).vector();
    const int index = layout_of<Graph>.outputs[at.first_output + Port].index;
    if constexpr (out.storage == storage_kind::of_beat) b.template at<array>(index).template put<out.port>();
    if constexpr (out.storage == storage_kind::newest || out.storage == storage_kind::past)
      b.template at<array>(index).put(coordinates, returned.origin(), b.k);
    if constexpr (out.leaves) b.state.template send<output>(coordinates, returned.origin(), b.k);
    constexpr int queue = queue_from<Graph>(out.first_reader);
    if constexpr (queue >= 0 && out.in_a_beat > 1)
      play_into_queues<Graph, output, queue>(b, coordinates, returned.origin());
    else if constexpr (queue >= 0) put_into_queues<Graph, queue>(b, coordinates, returned.origin());
    if constexpr (is_probed<Graph>)
      tell_recorder<Graph>(b.frame, at.first_output + Port, coordinates, returned.origin());
  }
}

}  // namespace cca::detail
