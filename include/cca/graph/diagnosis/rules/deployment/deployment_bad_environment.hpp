// deployment.bad_environment: a deployment consists of environments, each with a name of its own.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct deployment_bad_environment {
  static constexpr std::string_view id = "deployment.bad_environment";

  static constexpr bool is_broken(when::stated_environment, const flat_view& g, const finding& f) {
    const auto& e = g.environments[f.environment];
    return !e.unknown_type.empty() || !is_name(e.name) || has_name_before(g, f.environment);
  }

  static constexpr void tell(auto& m) {
    const auto& e = m.g.environments[m.found().environment];
    m.where << e.name;
    if (!e.unknown_type.empty()) {
      m.say() << "`" << e.unknown_type << "` in " << m.graph().name
              << " is nothing that a deployment consists of: write cca::environment<`name`, cca::nodes<`a`, "
                 "`b.c`>>, or cca::other_nodes as its second argument";
    } else if (!is_name(e.name)) {
      m.say() << "an environment of " << m.graph().name << " is named `" << e.name
              << "`: give it a name without dots and stars";
    } else {
      m.say() << m.graph().name << " has two environments named `" << e.name
              << "`: give each a name of its own, by it messages and other processes know it";
    }
  }

private:
  static constexpr bool has_name_before(const flat_view& g, int environment) {
    for (int e = 0; e < environment; ++e)
      if (g.environments[e].name == g.environments[environment].name) return true;
    return false;
  }
};

}  // namespace cca::detail
