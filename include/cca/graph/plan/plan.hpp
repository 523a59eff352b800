// The plan of a graph: everything that is known at compile time, as one constexpr value. This file is the
// list of the steps, in the order in which they run. Each takes a flat graph and returns it with more filled
// in; after a broken rule the steps that follow are skipped. Each variable below is a constant evaluation of
// its own, so that large graphs stay within the compilers' limits.
//
//   flatten       components and ports of all inner graphs, in arrays     flatten.hpp
//   connect       wires and observers bound to ports                      connect.hpp
//   find_rate     the length of a beat                                    rate.hpp
//   order_calls   the order of a beat                                     order.hpp
//   find_clocks   when each function fires                                clocks.hpp
//   find_feedback which delayed inputs close a loop                       feedback.hpp
//   choose_storage  how the samples of each output are stored             storage.hpp
//   check_whole   the rules about the finished plan                       whole.hpp
#pragma once

#include <cca/graph/plan/storage.hpp>
#include <cca/graph/plan/clocks.hpp>
#include <cca/graph/plan/connect.hpp>
#include <cca/graph/plan/flatten.hpp>
#include <cca/graph/plan/order.hpp>
#include <cca/graph/plan/rate.hpp>
#include <cca/graph/plan/whole.hpp>

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
};

// The next step, unless a rule is broken.
template <class Graph, class Step>
consteval flat_of<Graph> then(const flat_of<Graph>& before, Step step) {
  auto result = before;
  if (!result.counts.found.is_broken()) result.keep(step(result.view()));
  return result;
}

template <class Graph>
consteval flattened<Graph> flatten() {
  flattened<Graph> result;
  const name_table names{result.names.data(), names_size<Graph> - 1};
  result.graph.keep(flatten(result.graph.view(), graph_facts<Graph>::value, names));
  return result;
}
template <class Graph>
inline constexpr flattened<Graph> flattened_of = flatten<Graph>();

template <class Graph>
inline constexpr flat_of<Graph> connected_of = then<Graph>(flattened_of<Graph>.graph, [](flat_view g) {
  return connect(g, flattened_of<Graph>.names.data(), names_size<Graph> - 1,
                 graph_size<Graph>.observers * graph_size<Graph>.outputs);
});

template <class Graph>
inline constexpr flat_of<Graph> ordered_of =
    then<Graph>(connected_of<Graph>, [](flat_view g) { return order_calls(check_strategies(find_rate(g))); });

template <class Graph>
inline constexpr flat_of<Graph> clocked_of =
    then<Graph>(ordered_of<Graph>, [](flat_view g) { return find_clocks(g); });

template <class Graph>
inline constexpr flat_of<Graph> plan_of = then<Graph>(clocked_of<Graph>, [](flat_view g) {
  g.calls_in_part = calls_in_part<Graph>;
  return check_whole(choose_storage(find_feedback(g)), flattened_of<Graph>.names.data(),
                     names_size<Graph> - 1);
});

template <class Graph>
inline constexpr flat_view counts_of = plan_of<Graph>.counts;

}  // namespace cca::detail
