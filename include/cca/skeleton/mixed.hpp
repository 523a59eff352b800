// A sample between others, by the domain's own interpolation: on a line, on a circle, by slerp between
// orientations.
//
// With several weights, each sample is interpolated with the mean of those before it; on a line this is the
// weighted mean. A sample with weight zero does not influence the result, even if it is NaN; the origin is
// the oldest of the others. For a domain type without interpolation (a status) the result is the nearer
// sample. Cost: one interpolation per source but the first.
#pragma once

#include <array>
#include <cstddef>

#include <cca/space/sample.hpp>

namespace cca::detail {

// For 0 < t < 1.
template <class Space>
constexpr sample<Space> between(const sample<Space>& a, const sample<Space>& b, double t) {
  if constexpr (requires { a.interpolated(b, t); }) return a.interpolated(b, t);
  else return t < 0.5 ? a : b;
}

template <class Space>
constexpr sample<Space> mixed(const sample<Space>& a, const sample<Space>& b, double t) {
  return !(t > 0) ? a : t >= 1 ? b : between<Space>(a, b, t);
}

template <class Space, std::size_t Count, class... Rest>
constexpr sample<Space> mixed_of(const std::array<double, Count>& weights,
                                 const sample<Space>& first,
                                 const Rest&... rest) {
  sample<Space> mean = first;
  double sum = weights[0];
  std::size_t i = 1;
  ((sum += weights[i], mean = mixed<Space>(mean, rest, sum > 0 ? weights[i] / sum : 0), ++i), ...);
  return mean;
}

// Source `number`, counted from 0.
template <class Space, class... Rest>
constexpr sample<Space> one_of(int number, const sample<Space>& first, const Rest&... rest) {
  sample<Space> chosen = first;
  int i = 0;
  ((++i == number ? void(chosen = rest) : void()), ...);
  return chosen;
}

}  // namespace cca::detail
