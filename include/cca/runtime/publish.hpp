// What a function has returned goes where it is read: to the locals of the beat, to what is kept beyond it,
// into queues.
#pragma once

#include <tuple>

#include <cca/runtime/read.hpp>

namespace cca::detail {

// What one beat carries along: the reason of a fault, once there is one.
struct beat_outcome {
  const char* fault = nullptr;
  int node = -1;
};

template <class Graph, int Input, class Queue, class Value>
CCA_GLUE void push(Queue& q, beat_outcome& beat_outcome, const Value& value, std::int64_t origin) {
  constexpr const auto& in = input_of<Graph, Input>;
  if (q.count == q.capacity) {
    if constexpr (in.wire->full == full_kind::drop_oldest) {
      q.head = q.head + 1 == q.capacity ? 0 : q.head + 1;
      --q.count;
    } else {
      if constexpr (in.wire->full == full_kind::reject)
        beat_outcome = {"a sample arrived while the queue was full", call_of<Graph, in.call>.node};
      return;
    }
  }
  const int at = q.head + q.count;
  auto& place = q.ring[at < q.capacity ? at : at - q.capacity];
  copy_coordinates<size_of_input<Graph, Input>>(place.value, value);
  place.origin = origin;
  ++q.count;
}

// The next of an output's readers, from `input` on, that has a queue; -1: none.
template <class Graph>
constexpr int queue_from(int input) {
  const auto& inputs = plan_of<Graph>.inputs;
  while (input >= 0 && !is_queued(inputs[static_cast<std::size_t>(input)]))
    input = inputs[static_cast<std::size_t>(input)].next_of_writer;
  return input;
}

// Into the queues among the readers of an output, from reader `Input` on.
template <class Graph, int Input, class Value>
CCA_GLUE void push_to_queues(memory<Graph>& m,
                             beat_outcome& beat_outcome,
                             const Value& value,
                             std::int64_t origin) {
  constexpr seat queue = layout_of<Graph>.sources[Input];
  push<Graph, Input>(stored_at<Graph, queue.group>(m, m, queue.slot), beat_outcome, value, origin);
  constexpr int next = queue_from<Graph>(input_of<Graph, Input>.next_of_writer);
  if constexpr (next >= 0) push_to_queues<Graph, next>(m, beat_outcome, value, origin);
}

template <int Size, class Sample, class Value>
CCA_GLUE void store(Sample& to, const Value& value, std::int64_t origin) {
  copy_coordinates<Size>(to.value, value);
  to.origin = origin;
}

template <class Graph, int Output, class Result>
CCA_GLUE void publish(const Result& result,
                      memory<Graph>& m,
                      const output_seat<Graph, Output>& seat,
                      beat_outcome& beat_outcome,
                      std::int64_t k,
                      std::int64_t oldest) {
  constexpr const auto& out = output_of<Graph, Output>;
  if constexpr (requires { result.operator bool(); })
    if (!result) return;
  const std::int64_t own = result.origin();
  const std::int64_t origin = own == never ? oldest : own;
  const auto& value = result.vector();
  if constexpr (out.kept || out.local) {
    auto& newest = seat.newest.at;
    store<size_of_output<Graph, Output>>(newest, value, origin);
    if constexpr (!out.kept && !is_sure<Graph, Output>) newest.published = true;
    if constexpr (out.kept && out.stamped) newest.when = k;
  }
  if constexpr (out.ring > 0) {
    constexpr auto c = published_of<Graph, Output>;
    std::int64_t at;
    if constexpr (c.known()) at = (k - c.first) / c.period;
    else at = seat.past.at.count++;
    auto& entry = seat.past.at.entries[static_cast<std::size_t>(at) & static_cast<std::size_t>(out.ring - 1)];
    store<size_of_output<Graph, Output>>(entry, value, origin);
    entry.when = k;
  }
  constexpr int queue = queue_from<Graph>(out.first_reader);
  if constexpr (queue >= 0) push_to_queues<Graph, queue>(m, beat_outcome, value, origin);
}

// One of the results of a function, which is the output at `Position` there; a fault is none.
template <class Graph, int Position, int Output, class Result, class Places>
CCA_GLUE void publish_one(const Result& result,
                          const Places& places,
                          memory<Graph>& m,
                          beat_outcome& on,
                          std::int64_t k,
                          std::int64_t oldest,
                          int node) {
  if constexpr (std::is_same_v<Result, fault>) {
    if (result) on = {result.reason(), node};
  } else {
    publish<Graph, Output>(result, m, output_in<Position>(places), on, k, oldest);
  }
}

template <int... Number>
constexpr int number_at(int position, std::integer_sequence<int, Number...>) {
  constexpr int numbers[] = {Number..., -1};
  return numbers[position < 0 ? static_cast<int>(sizeof...(Number)) : position];
}

// All of them; `Outputs` are the numbers of the outputs that they are alike.
template <class Graph, class Outputs, class Result, class Places>
CCA_GLUE void publish_all(const Result& result,
                          const Places& places,
                          memory<Graph>& m,
                          beat_outcome& on,
                          std::int64_t k,
                          std::int64_t oldest,
                          int node,
                          list<Result>) {
  publish_one<Graph, 0, number_at(0, Outputs{})>(result, places, m, on, k, oldest, node);
}
template <class Graph, class Outputs, class Positions, class Results, class Places, std::size_t... I>
CCA_GLUE void publish_each(const Results& results,
                           const Places& places,
                           memory<Graph>& m,
                           beat_outcome& on,
                           std::int64_t k,
                           std::int64_t oldest,
                           int node,
                           std::index_sequence<I...>) {
  (publish_one<Graph, Positions::output_of_result[I], number_at(Positions::output_of_result[I], Outputs{})>(
       std::get<I>(results), places, m, on, k, oldest, node),
   ...);
}
template <class Graph, class Outputs, class... Results, class Places>
CCA_GLUE void publish_all(const std::tuple<Results...>& results,
                          const Places& places,
                          memory<Graph>& m,
                          beat_outcome& on,
                          std::int64_t k,
                          std::int64_t oldest,
                          int node,
                          list<Results...>) {
  publish_each<Graph, Outputs, function_ports<list<>, list<Results...>>>(
      results, places, m, on, k, oldest, node, std::index_sequence_for<Results...>{});
}

}  // namespace cca::detail
