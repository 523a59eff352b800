// Decimate: reduces the rate, by picking samples or by averaging them.
//
//   cca::node<"slow", cca::decimate<leg_angles_1000, leg_angles_100>>                   every tenth
//   cca::node<"slow", cca::decimate<leg_angles_1000, leg_angles_100, cca::averaged>>    the mean of each ten
//   in  "input"    From
//   out "output"   To, a `maybe`
//
// It counts samples, so it must fire with each of them (`restless`, the default). `picked`: the first sample
// and every n-th after it, with its origin. `averaged`: the mean of n samples, by the domain's own
// interpolation, with the oldest origin; published with the last of them.
// Errors: skeleton.arity, if From's rate is not a multiple of To's. Cost: a counter; averaged, one
// interpolation per sample. Example: tests/runtime/skeleton/rates.cpp; docs/skeletons.md.
#pragma once

#include <type_traits>

#include <cca/component/port.hpp>
#include <cca/skeleton/mixed.hpp>
#include <cca/skeleton/rate_change.hpp>

namespace cca {

struct picked {};
struct averaged {};

namespace detail {

template <class From, class To, class How>
struct decimate_of {
  auto process(in<"input", From> input) -> maybe<"output", To> {
    if (count != 0) {
      count = count + 1 == rate_ratio<From, To> ? 0 : count + 1;
      return {};
    }
    count = 1;
    return maybe<"output", To>(input.vector()).with_origin(input.origin());
  }
  void on_start() { count = 0; }

private:
  int count = 0;
};

template <class From, class To>
struct decimate_of<From, To, averaged> {
  auto process(in<"input", From> input) -> maybe<"output", To> {
    mean = count == 0 ? sample<From>(input) : between<From>(mean, input, 1.0 / (count + 1));
    if (++count < rate_ratio<From, To>) return {};
    count = 0;
    return maybe<"output", To>(mean.vector()).with_origin(mean.origin());
  }
  void on_start() { count = 0; }

private:
  sample<From> mean;
  int count = 0;
};

}  // namespace detail

template <class From, class To, class How = picked>
struct decimate
    : std::conditional_t<detail::differ_in_rate_only<From, To> && detail::rate_ratio<From, To> != 0,
                         detail::decimate_of<From, To, How>,
                         detail::bad_skeleton<detail::wrong_rates<From, To, true>>> {};

}  // namespace cca
