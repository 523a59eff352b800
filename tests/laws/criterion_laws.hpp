// The laws of a Criterion that measures a distance, stated once and run over every one of them.
//
// A case says of a criterion: `Case::criterion`; `Case::at(error)`, target and feedback that are so far apart.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

#include <cca/adaptive/criterion.hpp>

#include "ode_laws.hpp"

namespace laws {

template <class Case>
class criterion_rig {
public:
  using criterion = typename Case::criterion;
  criterion c{};

  criterion_rig() { c.p.limits = {0.1, 0.2, 0.5, 0.01}; }

  // For so many beats of a millisecond so far apart: the state at the end.
  cca::criterion_state feel(double error, int beats = 1) {
    double state = 0;
    for (int i = 0; i < beats; ++i, ++k) {
      const auto [target, feedback] = Case::at(error);
      using in_target = cca::in<"target", typename Case::space>;
      using in_feedback = cca::in<"feedback", typename Case::space>;
      const auto [e, s] = c.process(in_target(target, k, true), in_feedback(feedback, k, true), cca::beat(k, 1'000'000, 1));
      if (std::isfinite(error)) CHECK_MESSAGE(std::abs(e.vector()[0] - error) < 1e-9, "its error is the distance");
      state = s.vector()[0];
    }
    return static_cast<cca::criterion_state>(state);
  }

private:
  std::int64_t k = 0;
};

template <class Case>
void criterion() {
  static_assert(cca::Criterion<typename Case::criterion>);
  using enum cca::criterion_state;
  {
    criterion_rig<Case> one;
    using in_target = cca::in<"target", typename Case::space>;
    using in_feedback = cca::in<"feedback", typename Case::space>;
    const auto [e, s] = one.c.process(in_target(), in_feedback(), cca::beat(0, 1'000'000, 1));
    CHECK_MESSAGE(s.vector()[0] == cca::status_of(open), "before anything has come it is open");
  }
  criterion_rig<Case> one;
  CHECK_MESSAGE(one.feel(0.05, 9) == open, "not before it has held");
  CHECK_MESSAGE(one.feel(0.05) == fulfilled, "then it is fulfilled");
  CHECK_MESSAGE(one.feel(0.15, 50) == fulfilled, "between `within` and `until` it stays so");
  CHECK_MESSAGE(one.feel(0.25) == open, "beyond `until` it is open, at once");
  CHECK_MESSAGE(one.feel(0.15, 50) == open, "between `until` and `within` it stays so");
  CHECK_MESSAGE(one.feel(0.05, 9) == open, "it has to hold anew");
  CHECK_MESSAGE(one.feel(0.15) == open, "on end");
  CHECK_MESSAGE(one.feel(0.05, 9) == open, "on end");
  CHECK_MESSAGE(one.feel(0.05) == fulfilled, "then it is fulfilled");
  CHECK_MESSAGE(one.feel(0.6, 9) == open, "far off, but not for long");
  CHECK_MESSAGE(one.feel(0.6) == lost, "far off for long: lost");
  CHECK_MESSAGE(one.feel(0.3, 50) == lost, "between `lost` and `until` it stays so");
  CHECK_MESSAGE(one.feel(0.15) == open, "below `until` it is open again");
  CHECK_MESSAGE(one.feel(std::numeric_limits<double>::quiet_NaN()) == lost, "what is no number is lost, at once");
  const std::size_t before = allocations();
  for (int i = 0; i < 100; ++i) one.feel(0.01 * i);
  CHECK_MESSAGE(allocations() == before, "nothing allocates");
  one.c.on_start();
  CHECK_MESSAGE(one.feel(0.15) == open, "a start begins anew");
}

}  // namespace laws
