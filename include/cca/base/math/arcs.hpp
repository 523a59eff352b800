// atan, atan2, asin, acos, in radians. Straight-line: no branch, no table.
//
// Errors: at most 0.85 units in the last place; figures of many arguments in docs/math.md. NaN gives NaN, as
// does asin and acos of more than 1. atan2 as the C standard has it, with signs of zeros and infinite
// arguments. Templates on the scalar: double, float (computed in double), lanes.
//
// For t above tan(pi / 8), up to 1: atan(t) = pi / 4 + atan((t - 1) / (t + 1)).
// For x above 1/2: asin(x) = pi / 2 - 2 asin(sqrt((1 - x) / 2)).
// Coefficients: tests/runtime/math/coefficients.sollya.
#pragma once

#include <cca/base/math/roots.hpp>
#include <cca/base/math/rounding.hpp>

namespace cca::math {
namespace detail {

inline constexpr double arctangent_terms[] = {
    -0x1.5555555555555p-2, 0x1.999999999942ap-3, -0x1.249249243d6d3p-3, 0x1.c71c7188b5fb2p-4,
    -0x1.745d0b9b9317dp-4, 0x1.3b126be4cc799p-4, -0x1.10fae4e8f96b5p-4, 0x1.dfece4892f2fap-5,
    -0x1.a0b8db305b973p-5, 0x1.41b53c65a026cp-5, -0x1.3aebea585ede9p-6};
inline constexpr double arcsine_terms[] = {0x1.5555555555556p-3, 0x1.3333333332dcdp-4, 0x1.6db6db6e43981p-5,
                                           0x1.f1c71c14d9b43p-6, 0x1.6e8bb2fe34fc3p-6, 0x1.1c4d1bf7daaaep-6,
                                           0x1.c9d1cf12039fep-7, 0x1.780cd52779d39p-7, 0x1.52df2116769d9p-7,
                                           0x1.60a3c6394f323p-8, 0x1.205e79f9760c3p-6, -0x1.f07f36d83e73p-7,
                                           0x1.da67caf54e62dp-6};
inline constexpr double eighth_turn_high = 0x1.921fb54442dp-1;  // pi / 4; 47 bits: times 0 to 4 exact
inline constexpr double eighth_turn_low = 0x1.8469898cc5170p-49;

}  // namespace detail

// The angle of the point (x, y), -pi to pi.
template <Real T>
CCA_INLINE constexpr T atan2(T y, T x) {
  CCA_EXACT
  using namespace detail;
  const auto is_angle = (x == x) & (y == y);
  if (is_odd_constant(is_angle)) return all<T>(not_a_number);
  const T ax = magnitude(x), ay = magnitude(y);
  const auto is_steep = ay > ax;
  T more = pick(is_steep, ay, ax), less = pick(is_steep, ax, ay);
  less =
      pick(more == infinite, pick(less == infinite, 1.0, T{}), less);  // as it was of 1 and 1, or of 1 and 0
  more = pick((more == infinite) | (more == 0), 1.0, more);
  const T scale =
      pick(more > 0x1p1000, 0x1p-60, pick(more < 0x1p400, 0x1p500, all<T>(1)));  // nothing is subnormal
  more = more * scale, less = less * scale;

  const auto is_wide = less > more * 0x1.a827999fcef32p-2;  // tan(pi / 8)
  const pair<T> over = sum_of(less, pick(is_wide, T(-more), T{})),
                under = sum_of(more, pick(is_wide, less, T{}));
  const pair<T> u = quotient_of(over, under);
  const T z = product(u.high, u.high),
          rest = u.low + product(product(u.high, z), polynomial(z, arctangent_terms));

  // Eighths of a turn, and which way u counts from there.
  T eighths = pick(is_wide, 1.0, T{});
  eighths = pick(is_steep, T(2 - eighths), eighths);
  const auto is_left = bits(x) < 0;
  eighths = pick(is_left, T(4 - eighths), eighths);
  const T way = pick((is_steep != 0) != (is_left != 0), all<T>(-1), all<T>(1));
  const pair<T> sum = sum_of(product(eighths, eighth_turn_high), product(way, u.high));
  const T angle = sum.high + (sum.low + (product(way, rest) + product(eighths, eighth_turn_low)));
  return where(is_angle, with_sign_of(y, angle));
}

template <Real T>
CCA_INLINE constexpr T atan(T x) {
  CCA_EXACT
  using namespace detail;
  if (is_odd_constant(x == x)) return all<T>(not_a_number);
  const T all_of_it = magnitude(x), size = pick(all_of_it > 0x1p60, 0x1p60, all_of_it);  // also infinity
  const auto is_steep = size > 0x1.3504f333f9de6p+1,
             is_wide = size > 0x1.a827999fcef32p-2;  // 1 / tan(pi / 8), tan(pi / 8)
  // size, (size - 1) / (size + 1) or -1 / size: the angle from 0, pi / 4 or pi / 2.
  const T over = pick(is_steep, -1.0, pick(is_wide, T(size - 1), size)),
          steep_under = pick(is_steep, size, T(size + 1)), under = pick(is_wide, steep_under, 1.0);
  const auto is_between = is_wide & (is_steep == 0);
  const T lost = pick(is_between, T(size - (under - 1)), T{}),
          over_lost = pick(is_between, T(size - (over + 1)), T{});
  const pair<T> u = quotient_of(pair<T>{over, over_lost}, pair<T>{under, lost});
  const T z = product(u.high, u.high),
          rest = u.low + product(product(u.high, z), polynomial(z, arctangent_terms));
  const T high = pick(is_steep, 2 * eighth_turn_high, pick(is_wide, eighth_turn_high, T{}));
  const T low = pick(is_steep, 2 * eighth_turn_low, pick(is_wide, eighth_turn_low, T{}));

  const T angle = high + (u.high + (rest + low));
  return where(x == x, with_sign_of(x, angle));
}

namespace detail {

// asin(r) of r = sqrt(z) <= 1/2 in two parts; of `size` or, where that is above 1/2, of sqrt((1 - size) / 2).
template <Real T>
CCA_INLINE constexpr pair<T> half_arcsine(T size, T small) {
  CCA_EXACT
  const auto is_small = size <= 0.5;
  const T z = pick(is_small, product(size, size), T(0.5 * (1 - size))), root = near_sqrt(z),
          high = upper_26(root);
  const T lost = (z - product(high, high)) / (root + pick(z == 0, 1.0, high));  // root is high + lost
  const T r = pick(is_small, small, root);
  const T rest = product(product(r, z), polynomial(z, arcsine_terms));
  return {pick(is_small, small, high), pick(is_small, rest, T(rest + lost))};
}

}  // namespace detail

template <Real T>
CCA_INLINE constexpr T asin(T x) {
  CCA_EXACT
  using namespace detail;
  const T size = magnitude(x);
  if (is_odd_constant(size <= 1.0)) return all<T>(not_a_number);
  const pair<T> a = half_arcsine(size, size);
  const T large = 2 * ((eighth_turn_high - a.high) + (eighth_turn_low - a.low));
  return where(size <= 1.0, with_sign_of(x, pick(size <= 0.5, T(a.high + a.low), large)));
}

template <Real T>
CCA_INLINE constexpr T acos(T x) {
  CCA_EXACT
  using namespace detail;
  const T size = magnitude(x);
  if (is_odd_constant(size <= 1.0)) return all<T>(not_a_number);
  const pair<T> a = half_arcsine(size, x);
  // pi / 2 - asin(x), 2 asin(root), pi - 2 asin(root).
  const T small = 2 * eighth_turn_high - (a.high - (2 * eighth_turn_low - a.low));
  const T right = 2 * (a.high + a.low),
          left = 2 * ((2 * eighth_turn_high - a.high) + (2 * eighth_turn_low - a.low));
  return where(size <= 1.0, pick(size <= 0.5, small, pick(x > 0, right, left)));
}

}  // namespace cca::math
