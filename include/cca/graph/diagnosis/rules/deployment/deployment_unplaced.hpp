// deployment.unplaced: each component has an environment, in each mode.
#pragma once

#include <cca/graph/diagnosis/rule.hpp>

namespace cca::detail {

struct deployment_unplaced {
  static constexpr std::string_view id = "deployment.unplaced";

  static constexpr bool is_broken(when::placed_node, const flat_view&, const finding& f) {
    return f.environment < 0;
  }

  static constexpr void tell(auto& m) {
    m.at_node();
    m.node();
    m.of_mode();
    m.say() << " runs in no environment of " << m.deployment().name
            << ": add its path to the cca::nodes<...> of "
            << (m.g.environment_count == 1 ? "this environment" : "one of them")
            << ", or give one cca::other_nodes";
  }
};

}  // namespace cca::detail
