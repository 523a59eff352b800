// Interpolate: from a slower rate to a faster one, along the domain's own interpolation from sample to
// sample.
//
//   cca::node<"smooth", cca::interpolate<goal_at_100_hz, goal_at_1000_hz>, cca::timed<1>>
//   in  "input"    From
//   out "output"   To, with the older of the origins between which it lies
//
// A new sample is reached in as many firings as To's rate has to one of From's, from where the output is: so
// the output is continuous, and late by one period of From less one of To. A sample that is late finds it
// waiting at the one before. The first one is taken at once. The node's strategy makes the rate: one that is
// not To's is refused (rate.mismatch). Errors: skeleton.arity, where To's rate is no multiple of From's.
// Cost: an interpolation a firing. Example: tests/runtime/skeleton/rates.cpp; docs/skeletons.md.
#pragma once

#include <type_traits>

#include <cca/component/port.hpp>
#include <cca/skeleton/mixed.hpp>
#include <cca/skeleton/rate_change.hpp>

namespace cca {
namespace detail {

template <class From, class To>
struct interpolate_of {
  auto process(in<"input", From> input) -> out<"output", To> {
    if (input.fresh()) {
      from = last;
      step = begun ? 0 : count;
      begun = true;
    }
    if (step < count) ++step;
    last = step < count ? between<From>(from, input, static_cast<double>(step) / count) : sample<From>(input);
    return out<"output", To>(last.vector()).with_origin(last.origin());
  }

  void on_start() {
    begun = false;
    step = count;
  }

private:
  static constexpr int count = rate_ratio<To, From>;
  sample<From> from, last;
  int step = count;  // so many of its steps to the newest sample are done
  bool begun = false;
};

}  // namespace detail

template <class From, class To>
struct interpolate
    : std::conditional_t<detail::differ_in_rate_only<From, To> && detail::rate_ratio<To, From> != 0,
                         detail::interpolate_of<From, To>,
                         detail::uneven<detail::uneven_rates<From, To, false>>> {};

}  // namespace cca
