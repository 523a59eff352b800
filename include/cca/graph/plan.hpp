// The plan of a graph: all that is settled at compile time, as one constexpr value. Each step is an
// evaluation of its own, so that large graphs stay within the compilers' limits of constant evaluation.
#pragma once

#include <cca/graph/actuation.hpp>
#include <cca/graph/coordination.hpp>
#include <cca/graph/flatten.hpp>
#include <cca/graph/latency.hpp>
#include <cca/graph/plan/storage.hpp>
#include <cca/graph/wiring.hpp>

namespace cca::detail {

template <class Graph>
inline constexpr graph_sizes graph_size = graph_facts<Graph>::value.sizes;

template <class Graph>
using flat_of = flat<graph_size<Graph>.scopes,
                     graph_size<Graph>.nodes,
                     graph_size<Graph>.calls,
                     graph_size<Graph>.inputs,
                     graph_size<Graph>.outputs,
                     graph_size<Graph>.observers * graph_size<Graph>.outputs>;

template <class Graph>
inline constexpr std::uint64_t names_size =
    table_size(graph_size<Graph>.inputs + graph_size<Graph>.outputs + graph_size<Graph>.nodes +
               graph_size<Graph>.scopes + 4 * graph_size<Graph>.exposes);

template <class Graph>
struct flattened {
  flat_of<Graph> graph{};
  std::array<table_entry, names_size<Graph>> names{};
  std::string_view unknown_trigger{};
};

template <class Graph>
consteval flattened<Graph> flatten() {
  flattened<Graph> result;
  flattening step{result.graph.view(), {result.names.data(), names_size<Graph> - 1}};
  step.add_graph(graph_facts<Graph>::value, -1, nullptr, hash(""));
  result.unknown_trigger = step.unknown_trigger;
  result.graph.keep(step.g);
  return result;
}
template <class Graph>
inline constexpr flattened<Graph> flattened_of = flatten<Graph>();

// What a step makes of what the one before has left; nothing, once a rule is broken.
template <class Graph, class Step>
consteval flat_of<Graph> then(const flat_of<Graph>& before, Step step) {
  auto result = before;
  if (result.counts.found.broken == rule::none) result.keep(step(result.view()));
  return result;
}

template <class Graph>
inline constexpr flat_of<Graph> wired_of = then<Graph>(flattened_of<Graph>.graph, [](flat_view g) {
  wiring wires{g, flattened_of<Graph>.names.data(), names_size<Graph> - 1};
  wires.run(graph_size<Graph>.observers * graph_size<Graph>.outputs);
  return wires.g;
});

template <class Graph>
inline constexpr flat_of<Graph> ordered_of = then<Graph>(wired_of<Graph>, [](flat_view g) {
  clocking rates{g};
  rates.find_rate();
  for (int t = 0; t < rates.g.call_count; ++t) rates.check_strategy(t);
  ordering order{rates.g};
  order.run();
  return order.g;
});

template <class Graph>
inline constexpr flat_of<Graph> clocked_of = then<Graph>(ordered_of<Graph>, [](flat_view g) {
  clocking clocks{g};
  clocks.run();
  return clocks.g;
});

template <class Graph>
inline constexpr flat_of<Graph> plan_of = then<Graph>(clocked_of<Graph>, [](flat_view g) {
  g.calls_in_part = calls_in_part<Graph>;
  coordinating origins{choose_storage(find_feedback(g))};
  origins.run();
  actuation commands{origins.g};
  commands.run();
  requiring ages{commands.g, flattened_of<Graph>.names.data(), names_size<Graph> - 1};
  ages.run();
  return ages.g;
});

template <class Graph>
inline constexpr flat_view counts_of = plan_of<Graph>.counts;

}  // namespace cca::detail
