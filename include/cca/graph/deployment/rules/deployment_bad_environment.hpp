// deployment.bad_environment: a deployment is of a graph, and consists of environments that have a name of
// their own and at least one component. That it is no node of a graph stands in deployment_as_node.
#pragma once

#include <cca/graph/deployment/placement_events.hpp>

namespace cca::detail {

struct deployment_bad_environment {
  static constexpr std::string_view id = "deployment.bad_environment";

  static constexpr bool is_broken(when::stated_deployment, const flat_view& g, const finding&) {
    const auto& d = *placement_in(g).deployment;
    return !d.of_deployment.empty() || placement_in(g).count == 0 || d.tolerate_count > 1 || d.tolerated < 0;
  }
  static constexpr bool is_broken(when::stated_environment, const flat_view& g, const finding& f) {
    const auto& e = environment_in(g, environment_of(f));
    return e.mistake != misplaced::none || !is_name(e.name) || has_name_before(g, environment_of(f));
  }
  static constexpr bool is_broken(when::finished_environment, const flat_view& g, const finding& f) {
    for (int n = 0; n < g.node_count; ++n)
      if (g.nodes[n].place == environment_of(f)) return false;
    return true;
  }

  static constexpr void tell(auto& m) {
    const int e = environment_of(m.found());
    if (e < 0) tell_deployment(m);
    else if (environment_in(m.g, e).mistake != misplaced::none) tell_misplaced(m);
    else tell_environment(m);
  }

private:
  static constexpr bool has_name_before(const flat_view& g, int environment) {
    for (int e = 0; e < environment; ++e)
      if (environment_in(g, e).name == environment_in(g, environment).name) return true;
    return false;
  }

  static constexpr void tell_deployment(auto& m) {
    const auto& d = m.deployment();
    m.where << d.name;
    if (!d.of_deployment.empty())
      m.say() << d.name << " is a deployment of the deployment " << d.of_deployment
              << ", whose environments would be ignored: deploy its architecture instead, " << m.graph().name;
    else if (placement_in(m.g).count == 0)
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
    const auto& e = environment_in(m.g, environment_of(m.found()));
    m.where << (e.mistake == misplaced::item ? m.deployment().name : e.name);
    if (e.mistake == misplaced::item) {
      m.say() << "`" << e.unknown_type << "` in " << m.deployment().name
              << " is no item of a deployment, so it would be ignored: write cca::environment<`name`, "
                 "cca::nodes<`a`, `b.c`>>, or cca::tolerate<N>";
      return;
    }
    m.environment(environment_of(m.found()));
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
    const auto& e = environment_in(m.g, environment_of(m.found()));
    const auto deployment = m.deployment().name;
    m.where << (e.name.empty() ? deployment : e.name);
    if (e.name.empty()) {
      m.say() << "an environment of " << deployment
              << " has no name, so no message could name it: give it "
                 "one";
    } else if (!is_name(e.name)) {
      m.say() << "an environment of " << deployment << " is named `" << e.name
              << "`, but dots join names to paths, and `*` stands for any name: use neither in a name";
    } else if (has_name_before(m.g, environment_of(m.found()))) {
      m.say() << "two environments of " << deployment << " are named `" << e.name
              << "`, so a message about one of them has two meanings: give one another name";
    } else {
      m.environment(environment_of(m.found()));
      m.say() << " of " << deployment << " has no component, so it has nothing to run: "
              << (e.has_others ? "the other environments name every node; remove a path there, or this "
                                 "environment"
                               : "add the path of a node to its cca::nodes<...>, or remove it");
    }
  }
};

}  // namespace cca::detail
