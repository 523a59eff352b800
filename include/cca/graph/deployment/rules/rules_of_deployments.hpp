// The rules of deployments, in the order of graph/diagnosis/rules/rules.hpp, which they follow.
#pragma once

#include <cca/graph/deployment/rules/deployment_bad_environment.hpp>
#include <cca/graph/deployment/rules/deployment_free_running.hpp>
#include <cca/graph/deployment/rules/deployment_placed_twice.hpp>
#include <cca/graph/deployment/rules/deployment_undelayed.hpp>
#include <cca/graph/deployment/rules/deployment_unknown_node.hpp>
#include <cca/graph/deployment/rules/deployment_unplaced.hpp>

namespace cca::detail {

// clang-format off
struct deployment_rules {
  using type = list<
      deployment_bad_environment,
      deployment_unknown_node,
      deployment_unplaced,
      deployment_placed_twice,
      deployment_free_running,
      deployment_undelayed
  >;
};
// clang-format on

}  // namespace cca::detail
