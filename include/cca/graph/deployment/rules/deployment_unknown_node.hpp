// deployment.unknown_node: the paths in cca::nodes name components or inner graphs.
#pragma once

#include <cca/graph/diagnosis/nearest_node.hpp>
#include <cca/graph/deployment/placement_events.hpp>

namespace cca::detail {

struct deployment_unknown_node {
  static constexpr std::string_view id = "deployment.unknown_node";

  static constexpr bool is_broken(when::placed_path, const flat_view&, const finding&) { return true; }

  static constexpr void tell(auto& m) {
    const auto path = m.found().name;
    m.where << path;
    m.environment(environment_of(m.found()));
    m.say() << " names `" << path << "`, but ";
    if (m.deployment().mode.empty()) m.say() << m.graph().name << " has no such node";
    else m.say() << "no mode of " << m.deployment().name << " has such a node";
    if (const text best = nearest(m.g, path); best.size > 0)
      m.say() << "; did you mean `" << best.view() << "`?";
    else m.say() << ": write the path of a component or of an inner graph, as in `skills.gait`";
  }

private:
  static constexpr text nearest(const flat_view& g, std::string_view path) {
    node_search search{path};
    if (const auto* const all = placement_in(g).modes)
      for (int i = 0; i < all->count; ++i) search.look_in(*all->modes[i].plan);
    else search.look_in(g);
    return search.nearest;
  }
};

}  // namespace cca::detail
