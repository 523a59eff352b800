// Step 4, check the strategies: asks the rules about the strategy of each call, now that its wires are known
// and before the calls are ordered.
#pragma once

#include <cca/graph/diagnosis/rules/check.hpp>

namespace cca::detail {

constexpr flat_view check_strategies(flat_view g) {
  check_calls<when::connected_call>(g);
  return g;
}

}  // namespace cca::detail
