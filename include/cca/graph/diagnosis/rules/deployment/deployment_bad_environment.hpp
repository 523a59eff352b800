// deployment.bad_environment: a deployment is of a graph, and consists of environments that have a name of
// their own and at least one component.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct deployment_bad_environment {
  static constexpr std::string_view id = "deployment.bad_environment";

  static constexpr bool is_broken(when::named_node, const flat_view&, const finding& f) {
    return f.item->inner && f.item->inner->deployment;
  }
  static constexpr bool is_broken(when::stated_deployment, const flat_view& g, const finding&) {
    const auto& d = *g.scopes[0].graph->deployment;
    return !d.of_deployment.empty() || g.environment_count == 0 || d.tolerate_count > 1 || d.tolerated < 0;
  }
  static constexpr bool is_broken(when::stated_environment, const flat_view& g, const finding& f) {
    const auto& e = g.environments[f.environment];
    return e.mistake != misplaced::none || !is_name(e.name) || has_name_before(g, f.environment);
  }
  static constexpr bool is_broken(when::finished_environment, const flat_view& g, const finding& f) {
    for (int n = 0; n < g.node_count; ++n)
      if (g.nodes[n].environment == f.environment) return false;
    return true;
  }

  static constexpr void tell(auto& m) {
    const int e = m.found().environment;
    if (m.found().item) tell_node(m);
    else if (e < 0) tell_deployment(m);
    else if (m.g.environments[e].mistake != misplaced::none) tell_misplaced(m);
    else tell_environment(m);
  }

private:
  static constexpr bool has_name_before(const flat_view& g, int environment) {
    for (int e = 0; e < environment; ++e)
      if (g.environments[e].name == g.environments[environment].name) return true;
    return false;
  }

  static constexpr void tell_node(auto& m) {
    m.at_node();
    m.say() << "`" << m.where.view() << "` is the deployment " << m.item().inner->deployment->name
            << ", but inside of a graph its environments would be ignored: make it a node of the "
               "architecture, "
            << m.item().inner->name << ", and deploy the graph around it";
  }

  static constexpr void tell_deployment(auto& m) {
    const auto& d = m.deployment();
    m.where << d.name;
    if (!d.of_deployment.empty())
      m.say() << d.name << " is a deployment of the deployment " << d.of_deployment
              << ", whose environments would be ignored: deploy its architecture instead, " << m.graph().name;
    else if (m.g.environment_count == 0)
      m.say() << d.name
              << " has no environment: write cca::environment<`name`, cca::nodes<`a`, `b.c`>> after the "
                 "architecture, and one with cca::other_nodes";
    else if (d.tolerate_count > 1)
      m.say() << d.name << " states cca::tolerate more than once: leave one of them";
    else
      m.say() << "cca::tolerate<" << d.tolerated << "> in " << d.name
              << " is no number of late beats: write 0 or more";
  }

  static constexpr void tell_misplaced(auto& m) {
    const auto& e = m.g.environments[m.found().environment];
    m.where << (e.mistake == misplaced::item ? m.deployment().name : e.name);
    if (e.mistake == misplaced::item) {
      m.say() << "`" << e.unknown_type << "` in " << m.deployment().name
              << " is no item of a deployment, so it would be ignored: write cca::environment<`name`, "
                 "cca::nodes<`a`, `b.c`>>, or cca::tolerate<N>";
      return;
    }
    m.environment(m.found().environment);
    if (e.mistake == misplaced::nodes)
      m.say() << " has `" << e.unknown_type
              << "` in place of its nodes: write cca::nodes<`a`, `b.c`>, with the paths of components or "
                 "inner graphs, or cca::other_nodes";
    else if (e.mistake == misplaced::option)
      m.say()
          << " has the option `" << e.unknown_type
          << "`, but its options are cca::realtime<Priority, cca::on_core<N>>, cca::realtime_if_allowed and "
             "cca::free_running: write one of them, or none (all nodes go into one cca::nodes<...>)";
    else m.say() << " has two options of one kind, but one says how its thread runs: leave one of them";
  }

  static constexpr void tell_environment(auto& m) {
    const auto& e = m.g.environments[m.found().environment];
    const auto deployment = m.deployment().name;
    m.where << (e.name.empty() ? deployment : e.name);
    if (e.name.empty()) {
      m.say() << "an environment of " << deployment
              << " has no name, so no message could name it: give it "
                 "one";
    } else if (!is_name(e.name)) {
      m.say() << "an environment of " << deployment << " is named `" << e.name
              << "`, but dots join names to paths, and `*` stands for any name: use neither in a name";
    } else if (has_name_before(m.g, m.found().environment)) {
      m.say() << "two environments of " << deployment << " are named `" << e.name
              << "`, so a message about one of them has two meanings: give one another name";
    } else {
      m.environment(m.found().environment);
      m.say() << " of " << deployment << " has no component, so it has nothing to run: "
              << (e.has_others ? "the other environments name every node; remove a path there, or this "
                                 "environment"
                               : "add the path of a node to its cca::nodes<...>, or remove it");
    }
  }
};

}  // namespace cca::detail
