// deployment.unknown_node: the paths in cca::nodes name components or inner graphs.
#pragma once

#include <cca/graph/diagnosis/nearest_node.hpp>
#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct deployment_unknown_node {
  static constexpr std::string_view id = "deployment.unknown_node";

  static constexpr bool is_broken(when::placed_path, const flat_view&, const finding&) { return true; }

  static constexpr void tell(auto& m) {
    const auto path = m.found().name;
    m.where << path;
    m.environment(m.found().environment);
    m.say() << " names `" << path << "`, but ";
    if (m.deployment().mode.empty()) m.say() << m.graph().name << " has no such node";
    else m.say() << "no mode of " << m.deployment().name << " has such a node";
    const text best = m.g.modes ? nearest_node(*m.g.modes, path) : nearest_node(m.g, path);
    if (best.size > 0) m.say() << "; did you mean `" << best.view() << "`?";
    else m.say() << ": write the path of a component or of an inner graph, as in `skills.gait`";
  }
};

}  // namespace cca::detail
