// The Reaching Criterion: is the measured value at the reference, and at rest there? (the source document,
// chapter 3, *Criterion*)
//
//   cca::reaching_goal<paw_in_trunk>
//
//   in  "target"     S                the reference, where the movement should end
//   in  "feedback"   S                the measured value
//   out "error"      criterion_error  unit of S
//   out "state"      criterion_port
//
// Parameters `limits`: within, until, lost (unit of S), hold (s). The adaptive component reports `reached`
// only once its ode has converged too: passing the goal is not reaching it.
//
// While an input is NaN or infinite: error 1e12, state `lost`; afterwards `open`, and `hold` restarts.
//
// Errors: none. Cost: negligible. Example: tests/runtime/adaptive/kinds.cpp.
#pragma once

#include <cca/adaptive/tracking.hpp>

namespace cca {

template <Space S>
struct reaching_goal : detail::comparing<S> {
  static constexpr criterion_target compares = criterion_target::reference;
  static constexpr bool at_rest = true;
};

}  // namespace cca
