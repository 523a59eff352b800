// Hold: the newest sample, published again and again, at the rate of another space (a zero-order hold); and,
// if wired, frozen for as long as a flag says so.
//
//   cca::node<"goal", cca::hold<goal_at_10_hz, goal_at_1000_hz>, cca::timed<1>>
//   in  "input"    From
//   in  "freeze"   a status over x, optional: while it is not 0 the output stays what it is
//   out "output"   To, with the origin of the sample
//
// From and To differ in their rate only. The node's strategy makes the rate: one that is not To's is refused
// (rate.mismatch). Errors: skeleton.arity, where the spaces differ in more. Cost: none after inlining; with
// `freeze`, a sample of memory. Example: tests/runtime/skeleton/rates.cpp; docs/skeletons.md.
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
                                 detail::uneven<detail::uneven_rates<From, To, false>>> {};

}  // namespace cca
