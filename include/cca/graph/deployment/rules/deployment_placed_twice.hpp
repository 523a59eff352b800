// deployment.placed_twice: no component has two environments.
#pragma once

#include <cca/graph/deployment/placement_events.hpp>

namespace cca::detail {

struct deployment_placed_twice {
  static constexpr std::string_view id = "deployment.placed_twice";

  static constexpr bool is_broken(when::placed_node, const flat_view&, const finding& f) {
    return environment_of(f) >= 0;
  }
  static constexpr bool is_broken(when::stated_environment, const flat_view& g, const finding& f) {
    return environment_in(g, environment_of(f)).has_others && others_before(g, environment_of(f)) >= 0;
  }

  static constexpr void tell(auto& m) {
    const int second = environment_of(m.found());
    if (m.found().component < 0) {
      m.where << environment_in(m.g, second).name;
      m.say() << "cca::other_nodes stands in ";
      m.environment(others_before(m.g, second));
      m.say() << " and in ";
      m.environment(second);
      m.say() << ", so these components would run twice: keep it in one of them, and name the nodes of the "
                 "other";
      return;
    }
    m.at_node();
    m.node();
    m.of_mode();
    m.say() << " runs in ";
    m.environment(m.g.nodes[m.found().component].place);
    m.say() << " and in ";
    m.environment(second);
    m.say() << ": a component runs in one environment; remove it from one of the two (the path of an inner "
               "graph names all its components)";
  }

private:
  static constexpr int others_before(const flat_view& g, int environment) {
    for (int e = 0; e < environment; ++e)
      if (environment_in(g, e).has_others) return e;
    return -1;
  }
};

}  // namespace cca::detail
