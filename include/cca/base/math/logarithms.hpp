// log and pow. In their usual range straight-line: no branch but the question for it, no table.
//
// Errors: at most 0.85 units in the last place (log), 0.8 (pow), 1 where the result is subnormal; figures of
// many arguments in docs/math.md. log(0) is minus infinity, of a negative number NaN. pow as the C standard
// has it: pow(x, 0) and pow(1, y) are 1 also for NaN, a negative x takes whole y only. Templates on the
// scalar: double, float (computed in double), lanes.
//
// x = 2^k m, sqrt(1/2) <= m < sqrt(2), log(m) = 2 atanh(s), s = (m - 1) / (m + 1); for pow, base 2 and in two
// parts of which the first is so short that products are exact. Coefficients:
// tests/runtime/math/coefficients.sollya.
#pragma once

#include <cca/base/math/exponentials.hpp>
#include <cca/base/math/rounding.hpp>

namespace cca::math {
namespace detail {

inline constexpr double log_terms[] = {0x1.5555555555558p-1, 0x1.9999999995322p-2, 0x1.2492492deee3cp-2,
                                       0x1.c71c62e659d65p-3, 0x1.7462b4b7deb7bp-3, 0x1.39fe59b3246d8p-3,
                                       0x1.2b58bfd83bef5p-3};
// 3 atanh(s) / s = 3 + s^2 + s^4 (...)
inline constexpr double log_terms_of_power[] = {
    0x1.3333333333333p-1, 0x1.b6db6db6db97p-2,  0x1.5555555507f5ap-2, 0x1.1745d1b543714p-2,
    0x1.d89d504805619p-3, 0x1.99a8081f49e64p-3, 0x1.675cc0b06cde5p-3, 0x1.6a6e9226dbdc4p-3};

template <Real T>
struct parts {
  T mantissa;  // sqrt(1/2) to sqrt(2)
  T exponent;
};
template <Real T>
CCA_INLINE constexpr parts<T> parts_of(T x) {  // normal, positive
  const word<T> w = bits(x), k = (w - std::bit_cast<std::int64_t>(0x1.6a09e667f3bcdp-1)) >> 52;
  return {from_bits<T>(w - (k << 52)), number<T>(k)};
}
template <Real T>
CCA_INLINE constexpr auto is_normal(T x) {  // and positive
  return (x >= 0x1p-1022) & (x < infinite);
}

template <Real T>
CCA_INLINE constexpr T near_log(parts<T> p) {
  CCA_EXACT
  const T f = p.mantissa - 1, s = f / (2 + f), z = product(s, s), half = product(T(0.5 * f), f);
  const T rest = product(s, T(half + product(z, polynomial(z, log_terms)))) + product(p.exponent, log_2_low);
  return product(p.exponent, log_2_high) - ((half - rest) - f);
}
[[gnu::noinline]] constexpr double far_log(double x) {
  CCA_EXACT
  if (!(x > 0)) return x == 0 ? -infinite : not_a_number;
  if (x == infinite) return x;
  const parts<double> p = parts_of(x * 0x1p54);  // subnormal
  return near_log(parts<double>{p.mantissa, p.exponent - 54});
}

// The logarithm to base 2 in two parts, of which the first has 21 bits.
template <Real T>
CCA_INLINE constexpr pair<T> binary_log(parts<T> p) {
  CCA_EXACT
  const T f = p.mantissa - 1, inverse = 1 / (p.mantissa + 1), s = product(f, inverse), sh = upper_21(s);
  const T under = upper_21(T(p.mantissa + 1)), under_low = p.mantissa - (under - 1);
  const T sl = product(inverse, T((f - product(sh, under)) - product(sh, under_low)));
  const T z = product(s, s), square = product(sh, sh);
  const T more = product(product(z, z), polynomial(z, log_terms_of_power)) + product(sl, T(sh + s));
  const T third = upper_21(T((3 + square) + more)), third_low = more - ((third - 3) - square);
  const T u = product(sh, third), v = product(sl, third) + product(third_low, s);  // u + v = 3 atanh(s)
  const T high = upper_21(T(u + v)), low = v - (high - u);
  const T zh = product(high, 0x1.ec709p-1),
          zl = product(high, 0x1.b87407fae93f8p-22) + product(low, 0x1.ec709dc3a03fdp-1);  // 2 / (3 log 2)
  const T whole = upper_21(T((zh + zl) + p.exponent));
  return {whole, zl - ((whole - p.exponent) - zh)};
}

// 2^(y l) as its parts.
template <Real T>
CCA_INLINE constexpr pair<T> product_in_parts(T y, pair<T> l) {
  CCA_EXACT
  const T yh = upper_21(y);
  return {product(yh, l.high), product(T(y - yh), l.high) + product(y, l.low)};
}
template <Real T>
CCA_INLINE constexpr exponential<T> binary_exponential(pair<T> e) {  // |e| < 2^20
  CCA_EXACT
  const whole<T> k = nearest(T(e.high + e.low));
  const T left = e.high - k.value, t = upper_21(T(left + e.low));
  const T u = product(t, 0x1.62e42fe8p-1),
          v = product(T(e.low - (t - left)), 0x1.62e42fefa39efp-1) + product(t, 0x1.e8e7bcd5e4f1ep-31);
  const T r = u + v;
  return {growth_of(pair<T>{r, v - (r - u)}), k.bits};
}

[[gnu::noinline]] constexpr double far_pow(double x, double y) {
  CCA_EXACT
  if (x == 1 || y == 0) return 1;
  if (!(x == x) || !(y == y)) return not_a_number;
  const double many = magnitude(y), shifted = many + 0x1p52, size = magnitude(x);
  const bool is_whole = many >= 0x1p52 || shifted - 0x1p52 == many;
  const bool is_odd = is_whole && many < 0x1p53 && (bits(many < 0x1p52 ? shifted : many) & 1) == 1;
  const bool is_negative = bits(x) < 0;
  if (is_negative && !is_whole && size > 0 && size < infinite) return not_a_number;
  double result = (size > 0) == (y > 0) ? infinite : 0;
  if (size > 0 && size < infinite) {
    const bool is_small = size < 0x1p-1022;
    parts<double> p = parts_of(is_small ? size * 0x1p54 : size);
    if (is_small) p.exponent -= 54;
    const double power = y < -0x1p66  ? -0x1p66
                         : y > 0x1p66 ? 0x1p66
                                      : y;  // beyond, the result is 0, 1 or infinite
    pair<double> e = product_in_parts(power, binary_log(p));
    if (!(magnitude(e.high + e.low) < 1100)) e = {e.high + e.low > 0 ? 1100.0 : -1100.0, 0};
    result = scaled_exp(binary_exponential(e));
  }
  return is_negative && is_odd ? -result : result;
}

}  // namespace detail

template <Real T>
CCA_INLINE constexpr T log(T x) {
  if (!detail::everywhere(detail::is_normal(x))) [[unlikely]]
    return detail::lane_by_lane(
        x, [](double lane) { return detail::is_normal(lane) ? log(lane) : detail::far_log(lane); });
  return detail::near_log(detail::parts_of(x));
}

template <Real T>
CCA_INLINE constexpr T pow(T x, T y) {
  const auto is_usual = detail::is_normal(x) & (detail::magnitude(y) < 0x1p66);
  if constexpr (std::same_as<T, double>)
    if (detail::is_odd_constant(is_usual)) return detail::far_pow(x, y);
  // Without its sign: a negative x is not usual, but its parts are taken, and may not overflow.
  const detail::pair<T> e =
      detail::product_in_parts(y, detail::binary_log(detail::parts_of(detail::magnitude(x))));
  if (detail::everywhere(is_usual & (detail::magnitude(e.high) < 1000.0))) [[likely]]
    return detail::near_exp(detail::binary_exponential(e));
  if constexpr (std::same_as<T, double>) {
    return detail::far_pow(x, y);
  } else {
    for (std::size_t i = 0; i < sizeof(T) / sizeof(double); ++i) x[i] = pow(double(x[i]), double(y[i]));
    return x;
  }
}

}  // namespace cca::math
