// The plan of a graph: all that is settled at compile time, as one constexpr value. Each step is an evaluation of its
// own, so that large graphs stay within the compilers' limits of constant evaluation.
#pragma once

#include <cca/graph/actuation.hpp>
#include <cca/graph/coordination.hpp>
#include <cca/graph/flatten.hpp>
#include <cca/graph/latency.hpp>
#include <cca/graph/memory.hpp>
#include <cca/graph/wiring.hpp>

namespace cca::detail {

template <class Graph>
inline constexpr graph_sizes graph_size = graph_facts<Graph>::value.sizes;

template <class Graph>
using flat_of = flat<graph_size<Graph>.scopes, graph_size<Graph>.leaves, graph_size<Graph>.turns, graph_size<Graph>.inputs,
                     graph_size<Graph>.outputs, graph_size<Graph>.observers * graph_size<Graph>.outputs>;

template <class Graph>
inline constexpr std::uint64_t names_size = table_size(graph_size<Graph>.inputs + graph_size<Graph>.outputs + graph_size<Graph>.leaves +
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

template <class Graph>
consteval flat_of<Graph> wire_up() {
  auto result = flattened_of<Graph>.graph;
  if (result.counts.found.broken != rule::none) return result;
  wiring step{result.view(), flattened_of<Graph>.names.data(), names_size<Graph> - 1};
  step.run(graph_size<Graph>.observers * graph_size<Graph>.outputs);
  result.keep(step.g);
  return result;
}
template <class Graph>
inline constexpr flat_of<Graph> wired_of = wire_up<Graph>();

template <class Graph>
consteval flat_of<Graph> put_in_order() {
  auto result = wired_of<Graph>;
  if (result.counts.found.broken != rule::none) return result;
  clocking rates{result.view()};
  rates.find_rate();
  for (int t = 0; t < rates.g.turn_count; ++t) rates.check_strategy(t);
  ordering step{rates.g};
  step.run();
  result.keep(step.g);
  return result;
}
template <class Graph>
inline constexpr flat_of<Graph> ordered_of = put_in_order<Graph>();

template <class Graph>
consteval flat_of<Graph> find_clocks() {
  auto result = ordered_of<Graph>;
  if (result.counts.found.broken != rule::none) return result;
  clocking step{result.view()};
  step.run();
  result.keep(step.g);
  return result;
}
template <class Graph>
inline constexpr flat_of<Graph> clocked_of = find_clocks<Graph>();

template <class Graph>
consteval flat_of<Graph> remember() {
  auto result = clocked_of<Graph>;
  if (result.counts.found.broken != rule::none) return result;
  result.counts.turns_in_part = turns_in_part<Graph>;
  remembering step{result.view()};
  step.run();
  coordinating origins{step.g};
  origins.run();
  actuation commands{origins.g};
  commands.run();
  requiring ages{commands.g, flattened_of<Graph>.names.data(), names_size<Graph> - 1};
  ages.run();
  result.keep(ages.g);
  return result;
}
template <class Graph>
inline constexpr flat_of<Graph> plan_of = remember<Graph>();

template <class Graph>
inline constexpr flat_view counts_of = plan_of<Graph>.counts;

}  // namespace cca::detail
