// The plan of a deployment, and of each of its environments. The part of an environment is the same flat
// graph: its own calls, in the order of the whole, and the samples that come from the other environments.
#pragma once

#include <cca/graph/layout/types.hpp>
#include <cca/graph/deployment/place_components.hpp>
#include <cca/graph/plan/may_miss.hpp>
#include <cca/graph/planning/plan.hpp>
#include <cca/graph/marks/traceable.hpp>
#include <cca/graph/verdict/diagnosis.hpp>

namespace cca::detail {

template <Deployment D>
inline constexpr flat_of<D> plan_without_places = finished<D>();

// The plan of its architecture, and the place of each component.
template <Deployment D>
inline constexpr flat_of<D> plan_of<D> =
    then<D>(plan_without_places<D>, [](flat_view g) { return place_components(g, placement_of<D>); });

// The same in a wall-clock run, where nobody knows when a free-running environment publishes.
constexpr flat_view make_irregular(flat_view g) {
  for (int c = 0; c < g.call_count; ++c)
    g.calls[c].irregular = environment_in(g, environment_of(g, c)).is_free_running;
  return find_clocks(g);
}
template <Deployment D>
inline constexpr flat_of<D> plan_at_wall_clock = then<D>(plan_of<D>, make_irregular);

// Its architecture may break the rules of graphs.
template <class... First, class... Then>
list<First..., Then...> joined_rules(list<First...>, list<Then...>);
template <Deployment D>
struct told_of<D> {
  using rules = decltype(joined_rules(detail::rules{}, deployment_rules::type{}));
  using writer = deployment_writer;
};

// Its architecture is no graph.
template <class D>
  requires requires { typename D::cca_architecture; }
struct no_graph<D> {
  using named = typename D::cca_architecture;
  static constexpr void tell(auto& message) {
    message << "` in " << type_name<D>()
            << " is no graph: the first argument of cca::deployment is the architecture, a struct derived "
               "from cca::graph<...> or, of several modes, from cca::modes<...>, and the environments follow";
  }
};

// Does a node run in a free-running environment of a deployment?
template <class Graph>
constexpr bool is_free_node(int) {
  return false;
}
template <AnyDeployment D>
constexpr bool is_free_node(int node) {
  return environments_of<D>::all[array_size(plan_of<D>.nodes[array_size(node)].place)].is_free_running;
}

// Environment `E` of a deployment, as a graph.
template <class D, int E>
struct part : marks_of<D> {
  using cca_items = typename D::cca_items;
};

template <class D, int E>
inline constexpr graph_sizes graph_size<part<D, E>> = graph_size<D>;

template <class D, int E>
inline constexpr heard_count heard_count_of<part<D, E>> = heard_count_of<D>;

// The nodes are those of the architecture.
template <class D, int E, int Node>
struct node_types<part<D, E>, Node> : node_types<D, Node> {};

// What is published elsewhere enters this queue in the same beat: one of the two environments is
// free-running.
constexpr bool crosses_at_once(const flat_view& g, const input& way) {
  return is_queued(way) && way.delay == 0 &&
         environment_of(g, way.call) != environment_of(g, g.outputs[way.writer].call);
}

// Keeps the calls of one environment, in their order.
constexpr flat_view take_part(flat_view g, int environment) {
  const auto is_here = [&](int call) { return environment_of(g, call) == environment; };
  int count = 0;
  g.may_fault = false;
  for (int r = 0; r < g.call_count; ++r) {
    const int index = g.order[r];
    auto& c = g.calls[index];
    c.elsewhere = !is_here(index);
    if (c.elsewhere) continue;
    c.rank = count;
    g.order[count++] = index;
    g.may_fault |= may_fault_in(g, c);
  }
  g.order_count = count;
  forget_storage(g);
  for (int i = 0; i < g.input_count; ++i) {
    auto& in = g.inputs[i];
    in.watched &= is_here(in.call);
    g.may_fault |= !g.calls[in.call].elsewhere &&
                   (may_fault_at_begin(in) || (crosses_at_once(g, in) && in.wire->full == full_kind::reject));
  }
  find_missing(g);
  for (int o = 0; o < g.output_count; ++o) {
    auto& out = g.outputs[o];
    out.watched &= is_here(out.call);
    if (is_here(out.call))
      for_each_reader(g, o, [&](int reader, int) { out.leaves |= reader != environment; });
  }
  return g;
}

template <class D, int E>
inline constexpr int calls_in_part<part<D, E>> = calls_in_part<D>;

template <class D, int E>
inline constexpr flat_of<D> plan_of<part<D, E>> = then<D>(plan_of<D>, [](flat_view g) {
  g.calls_in_part = calls_in_part<D>;
  return choose_storage(find_clocks(take_part(g, E)));
});

}  // namespace cca::detail
