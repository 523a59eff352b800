// Interpolate: from a slower rate to a faster one, by the domain's own interpolation from sample to sample.
//
//   cca::node<"smooth", cca::interpolate<goal_at_100_hz, goal_at_1000_hz>, cca::timed<1>>
//   in  "input"    From
//   out "output"   To, with the older origin of the two samples between which it lies
//
// The output moves from where it is to a new sample in n firings, where n is To's rate divided by From's. So
// it is continuous, and late by one period of From less one of To. If a sample is late, the output waits at
// the previous one. The first sample is taken at once. The node's strategy sets the rate; another rate than
// To's is refused (rate.mismatch). Errors: skeleton.arity, if To's rate is not a multiple of From's. Cost:
// one interpolation per firing. Example: tests/runtime/skeleton/rates.cpp; docs/skeletons.md.
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
  int step = count;  // steps done towards the newest sample
  bool begun = false;
};

}  // namespace detail

template <class From, class To>
struct interpolate
    : std::conditional_t<detail::differ_in_rate_only<From, To> && detail::rate_ratio<To, From> != 0,
                         detail::interpolate_of<From, To>,
                         detail::bad_skeleton<detail::wrong_rates<From, To, false>>> {};

}  // namespace cca
