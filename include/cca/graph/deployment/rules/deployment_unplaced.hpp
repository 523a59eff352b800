// deployment.unplaced: each component has an environment, in each mode.
#pragma once

#include <cca/graph/deployment/placement_events.hpp>

namespace cca::detail {

struct deployment_unplaced {
  static constexpr std::string_view id = "deployment.unplaced";

  static constexpr bool is_broken(when::placed_node, const flat_view&, const finding& f) {
    return environment_of(f) < 0;
  }

  static constexpr void tell(auto& m) {
    m.at_node();
    m.node();
    m.of_mode();
    m.say() << " runs in no environment of " << m.deployment().name
            << ": add its path to the cca::nodes<...> of "
            << (placement_in(m.g).count == 1 ? "this environment" : "one of them")
            << ", or give one cca::other_nodes";
  }
};

}  // namespace cca::detail
