// Hold: publishes the newest sample again and again, at the rate of another space (a zero-order hold).
// Optionally a flag freezes the output.
//
//   cca::node<"goal", cca::hold<goal_at_10_hz, goal_at_1000_hz>, cca::timed<1>>
//   in  "input"    From
//   in  "freeze"   a status over x, optional: while it is not 0 the output does not change
//   out "output"   To, with the origin of the sample
//
// From and To may differ only in their rate. The node's strategy sets the rate; another rate than To's is
// refused (rate.mismatch). Errors: skeleton.arity, if the spaces differ in more. Cost: none after inlining;
// with `freeze` wired, memory for one sample. Example: tests/runtime/skeleton/rates.cpp; docs/skeletons.md.
#pragma once

#include <type_traits>

#include <cca/component/port.hpp>
#include <cca/skeleton/rate_change.hpp>
#include <cca/skeleton/signals.hpp>

namespace cca {
namespace detail {

template <class From, class To>
struct hold_of {
  auto process(in<"input", From> input, optional_in<"freeze", flag> freeze) -> out<"output", To> {
    if (!freeze) return out<"output", To>(input.vector()).with_origin(input.origin());
    if (freeze.vector().coeff(0) == 0 || kept.origin() == never) kept = input;
    return out<"output", To>(kept.vector()).with_origin(kept.origin());
  }

  void on_start() { kept = {}; }

private:
  sample<From> kept;
};

}  // namespace detail

template <class From, class To = From>
struct hold : std::conditional_t<detail::differ_in_rate_only<From, To>,
                                 detail::hold_of<From, To>,
                                 detail::bad_skeleton<detail::wrong_rates<From, To, false>>> {};

}  // namespace cca
