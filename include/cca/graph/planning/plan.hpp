// The plan of a graph: everything that is known at compile time, as one constexpr value. This file is the
// list of the steps, in the order in which they run; each has a header in steps/. A step takes a flat graph
// and returns it with more filled in; after a broken rule the steps that follow are skipped. Each variable
// below is a constant evaluation of its own, so that large graphs stay within the compilers' limits.
//
//   flatten           components and ports of all inner graphs, in arrays     flatten.hpp
//   connect           wires bound to ports                                    connect.hpp
//   listen            observers bound to what their patterns name             listen.hpp
//   find_rate         the length of a beat                                    rate.hpp
//   check_strategies  the rules about strategies                              check_strategies.hpp
//   order_calls       the order of a beat                                     order.hpp
//   find_clocks       when each function fires                                clocks.hpp
//   find_feedback     which delayed inputs close a loop                       feedback.hpp
//   choose_storage    how the samples of each output are stored               storage.hpp
//   check_whole       the rules about the finished plan                       whole.hpp
//
// Wings add steps of their own; a wing is what is built on graphs in a folder beside this one.
#pragma once

#include <cca/graph/plan/flat.hpp>
#include <cca/graph/plan/long_beats.hpp>
#include <cca/graph/plan/names.hpp>
#include <cca/graph/planning/steps/flatten.hpp>
#include <cca/graph/planning/steps/connect.hpp>
#include <cca/graph/planning/steps/listen.hpp>
#include <cca/graph/planning/steps/rate.hpp>
#include <cca/graph/planning/steps/check_strategies.hpp>
#include <cca/graph/planning/steps/order.hpp>
#include <cca/graph/planning/steps/clocks.hpp>
#include <cca/graph/planning/steps/feedback.hpp>
#include <cca/graph/planning/steps/storage.hpp>
#include <cca/graph/planning/steps/whole.hpp>

namespace cca::detail {

template <class Graph>
inline constexpr graph_sizes graph_size = graph_facts<Graph>::value.sizes;

// With room for so many links.
template <class Graph, int Links, int Taken = 0>
using flat_with = flat<graph_size<Graph>.scopes,
                       graph_size<Graph>.nodes,
                       graph_size<Graph>.calls,
                       graph_size<Graph>.ways() + Links,
                       graph_size<Graph>.outputs + Taken,
                       Links,
                       graph_size<Graph>.parts,
                       graph_size<Graph>.part_requests>;

template <class Graph>
inline constexpr std::uint64_t names_size =
    table_size(graph_size<Graph>.inputs + graph_size<Graph>.outputs + graph_size<Graph>.nodes +
               graph_size<Graph>.scopes + 4 * graph_size<Graph>.exposes);

template <class Graph>
struct flattened {
  flat_with<Graph, 0> graph{};
  std::array<table_entry, names_size<Graph>> names{};
};

// The next steps, until a rule is broken.
template <class Graph, class Flat, class... Steps>
consteval Flat then(const Flat& before, Steps... steps) {
  auto result = before;
  flat_view g = result.view();
  ((g = g.found.is_broken() ? g : steps(g)), ...);
  result.keep(g);
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
inline constexpr flat_with<Graph, 0> connected_of = then<Graph>(flattened_of<Graph>.graph, [](flat_view g) {
  return connect(g, flattened_of<Graph>.names.data(), names_size<Graph> - 1);
});

// What the observers of a graph hear.
template <class Graph>
inline constexpr heard_count heard_count_of = [] {
  if constexpr (graph_size<Graph>.observers == 0 && graph_size<Graph>.watches == 0) {
    return heard_count();
  } else {
    auto connected = connected_of<Graph>;
    return connected.counts.found.is_broken() ? heard_count() : count_heard(connected.view());
  }
}();
template <class Graph>
inline constexpr int link_count_of = heard_count_of<Graph>.links;

template <class Graph>
using flat_of = flat_with<Graph, link_count_of<Graph>, heard_count_of<Graph>.taken>;

// Of ports, of ways into them, and of links.
template <class Graph>
inline constexpr int input_count_of = graph_size<Graph>.ways() + link_count_of<Graph>;
// Of ports, and of what is taken from queues.
template <class Graph>
inline constexpr int output_room_of = graph_size<Graph>.outputs + heard_count_of<Graph>.taken;

template <class Graph>
consteval flat_of<Graph> listened() {
  if constexpr (link_count_of<Graph> == 0) {
    return then<Graph>(connected_of<Graph>, listen);
  } else {
    flat_of<Graph> result;
    connected_of<Graph>.widen(result);
    return then<Graph>(result, listen);
  }
}
template <class Graph>
inline constexpr flat_of<Graph> listened_of = listened<Graph>();

template <class Graph>
inline constexpr flat_of<Graph> ordered_of =
    then<Graph>(listened_of<Graph>, find_rate, check_strategies, order_calls);

template <class Graph>
inline constexpr flat_of<Graph> clocked_of = then<Graph>(ordered_of<Graph>, find_clocks);

template <class Graph>
consteval flat_of<Graph> finished() {
  const auto check = [](flat_view g) {
    return check_whole(g, flattened_of<Graph>.names.data(), names_size<Graph> - 1);
  };
  auto clocked = clocked_of<Graph>;
  clocked.counts.calls_in_part = calls_in_part<Graph>;
  return then<Graph>(clocked, find_feedback, choose_storage, check);
}
template <class Graph>
inline constexpr flat_of<Graph> plan_of = finished<Graph>();

template <class Graph>
inline constexpr flat_view counts_of = plan_of<Graph>.counts;

}  // namespace cca::detail
