// Step 10, of deployments only, place: gives each component of a deployment its environment. It comes last,
// so a mistake of the architecture is reported before one of its placement.
#pragma once

#include <cca/graph/diagnosis/rules/check.hpp>
#include <cca/graph/deployment/environments.hpp>
#include <cca/graph/deployment/rules/rules_of_deployments.hpp>
#include <cca/graph/plan/flat.hpp>
#include <cca/graph/modes/mode_info.hpp>
#include <cca/graph/plan/names.hpp>

namespace cca::detail {

// Calls f(environment, delay) for each reader of an output.
template <class F>
constexpr void for_each_reader(const flat_view& g, int output, F f) {
  for (int i = g.outputs[output].first_reader; i >= 0; i = g.inputs[i].next_of_writer)
    f(environment_of(g, g.inputs[i].call), g.inputs[i].delay);
}

// Is the node, or a graph around it, at this path?
constexpr bool is_at(const flat_view& g, const component_node& n, std::uint64_t path) {
  if (path_hash(g.scopes[n.scope], n.item->from, n.item->from_hash) == path) return true;
  for (int s = n.scope; s > 0; s = g.scopes[s].parent)
    if (g.scopes[s].hash == path) return true;
  return false;
}

// The graph in which a wire stands: the innermost around its reader that has it.
constexpr int scope_of_wire(const flat_view& g, const input& in) {
  for (int s = scope_of_call(g, g.calls[in.call]); s >= 0; s = g.scopes[s].parent)
    for (int i = 0; i < g.scopes[s].graph->count; ++i)
      if (&g.scopes[s].graph->items[i] == &*in.wire) return s;
  return 0;
}

// All components have their place. Of a set of modes: those of all modes.
constexpr void check_environments(flat_view& g) {
  for (int e = 0; e < placement_in(g).count; ++e) check<when::finished_environment>(g, {.numbers = {e}});
}

struct placer {
  flat_view g;
  const modes_info* modes = placement_in(g).modes;

  constexpr void place(int node, int environment) {
    auto& n = g.nodes[node];
    if (n.place >= 0 && n.place != environment)
      check<when::placed_node>(
          g, {.item = n.item, .scope = n.scope, .component = node, .numbers = {environment}});
    if (n.place < 0) n.place = environment;
  }

  constexpr void place_named() {
    check<when::stated_deployment>(g, {});
    for (int e = 0; e < placement_in(g).count; ++e) {
      const auto& environment = environment_in(g, e);
      check<when::stated_environment>(g, {.numbers = {e}});
      for (int p = 0; p < environment.path_count; ++p) {
        const auto path = hash(environment.paths[p]);
        bool found = false;
        for (int n = 0; n < g.node_count; ++n)
          if (is_at(g, g.nodes[n], path)) {
            found = true;
            place(n, e);
          }
        if (!found && !is_in_other_mode(path))
          check<when::placed_path>(g, {.numbers = {e}, .name = environment.paths[p]});
      }
    }
  }

  constexpr bool is_in_other_mode(std::uint64_t path) const {
    if (!modes) return false;
    for (int m = 0; m < modes->count; ++m) {
      const flat_view& other = *modes->modes[m].plan;
      for (int n = 0; n < other.node_count; ++n)
        if (is_at(other, other.nodes[n], path)) return true;
    }
    return false;
  }

  constexpr void place_others() {
    int others = -1;
    for (int e = 0; e < placement_in(g).count && others < 0; ++e)
      if (environment_in(g, e).has_others) others = e;
    for (int n = 0; n < g.node_count; ++n) {
      auto& node = g.nodes[n];
      if (node.place < 0) node.place = others;
      if (node.place < 0)
        check<when::placed_node>(g, {.item = node.item, .scope = node.scope, .component = n});
    }
    if (!modes) check_environments(g);
    for (int n = 0; n < g.node_count; ++n)
      if (const auto& node = g.nodes[n]; node.place >= 0 && environment_in(g, node.place).is_free_running)
        check<when::free_node>(
            g, {.item = node.item, .scope = node.scope, .component = n, .numbers = {node.place}});
  }

  constexpr void check_crossings() {
    for (int i = 0; i < g.first_link; ++i) {
      const auto& in = g.inputs[i];
      if (in.writer >= 0 && environment_of(g, in.call) != environment_of(g, g.outputs[in.writer].call))
        check<when::crossing>(
            g, {.item = &*in.wire, .scope = scope_of_wire(g, in), .input = i, .output = in.writer});
    }
    for (int i = g.first_link; i < g.input_count; ++i) {
      const auto& in = g.inputs[i];
      const auto& reader = g.nodes[g.calls[in.call].node];
      const finding facts{.item = reader.item, .scope = reader.scope, .input = i, .output = in.writer};
      if (reader.place != environment_of(g, g.outputs[in.writer].call)) check<when::crossing>(g, facts);
      if (in.shows >= 0 && reader.place != environment_of(g, g.inputs[in.shows].call))
        check<when::queue_shown_elsewhere>(g, facts);
    }
  }

  constexpr void run() {
    place_named();
    place_others();
    if (g.found.is_broken()) return;
    check_crossings();
  }
};

constexpr flat_view place_components(flat_view g, const deployment_placement& facts) {
  g.hung = &facts;
  g.is_spread = facts.count > 0;
  placer step{g};
  step.run();
  return step.g;
}

}  // namespace cca::detail
