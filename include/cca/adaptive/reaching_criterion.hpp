// The Reaching Criterion: is what is measured where it was asked to go, and at rest there (seed, chapter 3,
// *Criterion*).
//
//   cca::reaching_goal<paw_in_trunk>
//   in  "target"     S: the reference, where it should end
//   in  "feedback"   S: what is measured
//   out "error"      criterion_error, in the unit of S
//   out "state"      criterion_port
//
// Parameters `limits`: within, until, lost (in the unit of S), hold (s). Its adaptive component has reached
// its goal only once its ode has converged, too: passing by is not arriving. Cost: nothing to speak of.
// Example: tests/runtime/adaptive/kinds.cpp.
#pragma once

#include <cca/adaptive/tracking.hpp>

namespace cca {

template <Space S>
struct reaching_goal : detail::comparing<S> {
  static constexpr criterion_target compares = criterion_target::reference;
  static constexpr bool at_rest = true;
};

}  // namespace cca
