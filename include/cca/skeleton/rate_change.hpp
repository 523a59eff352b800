// Shared by hold, decimate and interpolate, which lead from one rate to another. Their two spaces agree in
// domain type and axes; for decimate and interpolate one rate must be a whole multiple of the other
// (skeleton.arity).
#pragma once

#include <type_traits>

#include <cca/skeleton/arity.hpp>
#include <cca/space/info.hpp>

namespace cca::detail {

template <class Space>
constexpr double rate_of = hz_of<typename Space::rate>;

template <class From, class To>
constexpr bool differ_in_rate_only = std::is_same_v<typename From::domain, typename To::domain> &&
                                     std::is_same_v<typename From::axes, typename To::axes>;

// How many samples of Fast there are per sample of Slow; 0 if it is not a whole number of at least 2.
template <class Fast, class Slow>
constexpr int rate_ratio = [] {
  if (!(rate_of<Slow> > 0) || !(rate_of<Fast> > rate_of<Slow>)) return 0;
  const auto whole = static_cast<int>(rate_of<Fast> / rate_of<Slow> + 0.5);
  const double off = whole * rate_of<Slow> - rate_of<Fast>;
  return off < 1e-9 * rate_of<Fast> && -off < 1e-9 * rate_of<Fast> ? whole : 0;
}();

template <class Space>
constexpr void put_rate(text& t) {
  t << type_name<Space>() << " (";
  if (rate_of<Space> > 0) t << rate_of<Space> << " Hz)";
  else t << "no rate stated)";
}

// Down: to a slower rate; else to a faster one.
template <class From, class To, bool Down>
struct wrong_rates {
  static constexpr text message() {
    text t;
    t << "leads from ";
    put_rate<From>(t);
    t << " to ";
    put_rate<To>(t);
    if (!differ_in_rate_only<From, To>)
      t << ", which differ in more than their rate: name two spaces of one domain type over the same axes";
    else
      t << ", but the first must have a rate that is "
        << (Down ? "a whole multiple of that of the second, at least twice it"
                 : "a whole part of that of the second, at most half of it")
        << ": state rates like " << (Down ? "1000 and 100 Hz" : "100 and 1000 Hz");
    return t;
  }
};

}  // namespace cca::detail
