// exp, expm1, sinh, cosh, tanh. In their usual range straight-line: no branch but the question for it, no
// table.
//
// Errors: at most 0.65 units in the last place (exp), 0.95 (expm1, sinh, cosh, tanh), 1 where exp's result is
// subnormal; figures of many arguments in docs/math.md. Too large gives infinity, too small zero, NaN gives
// NaN. Templates on the scalar: double, float (computed in double), lanes.
//
// x = k log 2 + r, |r| <= log(2) / 2, exp(r) = 1 + r + r^2 E(r), with what rounding left out of each part.
// Coefficients: tests/runtime/math/coefficients.sollya.
#pragma once

#include <cca/base/math/rounding.hpp>

namespace cca::math {
namespace detail {

inline constexpr double exponential_terms[] = {0x1p-1,
                                               0x1.5555555555557p-3,
                                               0x1.5555555555552p-5,
                                               0x1.1111111110056p-7,
                                               0x1.6c16c16c18931p-10,
                                               0x1.a01a01ac1a73cp-13,
                                               0x1.a01a0197bcfeap-16,
                                               0x1.71de01b88045bp-19,
                                               0x1.27e500e0a3181p-22,
                                               0x1.af4eb2bd1e104p-26,
                                               0x1.1f32eabba0b76p-29};
inline constexpr double log_2_high = 0x1.62e42fefa38p-1;  // 42 bits: times k exact
inline constexpr double log_2_low = 0x1.ef35793c7673p-45;

// exp(r) - 1 of |r| <= log(2) / 2 in two parts.
template <Real T>
CCA_INLINE constexpr pair<T> growth_of(pair<T> r) {
  CCA_EXACT
  return {r.high, r.low + (product(product(r.high, r.high), polynomial(r.high, exponential_terms)) +
                           product(r.high, r.low))};
}

// exp(x) = 2^k (1 + grown), |x| < 2^20.
template <Real T>
struct exponential {
  pair<T> grown;
  word<T> k;  // its upper bits are others
};
template <Real T>
CCA_INLINE constexpr exponential<T> exponential_of(T x) {
  CCA_EXACT
  const whole<T> k = nearest(product(x, 0x1.71547652b82fep+0));
  const T y = x - product(k.value, log_2_high), second = product(k.value, log_2_low), r = y - second;
  return {growth_of(pair<T>{r, (y - r) - second}), k.bits};
}
template <Real T>
CCA_INLINE constexpr T near_exp(exponential<T> e) {  // 2^k and the result are normal
  CCA_EXACT
  const pair<T> s = fast_sum_of(all<T>(1), e.grown.high);
  return from_bits<T>(bits(T(s.high + (s.low + e.grown.low))) + (e.k << 52));
}

// m 2^k in two steps: a subnormal result is rounded once, a large one becomes infinite. |k| < 2000.
constexpr double scaled(double m, std::int64_t k) {
  CCA_EXACT
  if (k > 1023 && m >= power_of_two<double>(1024 - k)) return infinite;
  const std::int64_t half = k >> 1;
  return m * power_of_two<double>(half) * power_of_two<double>(k - half);
}
constexpr double scaled_exp(exponential<double> e) {
  CCA_EXACT
  const pair<double> s = fast_sum_of(1.0, e.grown.high);
  return scaled(s.high + (s.low + e.grown.low), e.k - std::bit_cast<std::int64_t>(upper_half));
}
[[gnu::noinline]] constexpr double far_exp(double x) {
  if (!(x == x)) return not_a_number;
  return scaled_exp(exponential_of(x < -746 ? -746 : x > 710 ? 710 : x));
}

// (exp(x) - 1) / 4 in two parts, -60 <= x <= 710.5: a quarter, so that what is made of it is infinite no
// sooner than it must be.
template <Real T>
CCA_INLINE constexpr pair<T> quarter_of_growth(T x) {
  CCA_EXACT
  const exponential<T> e = exponential_of(x);
  const T scale = power_of_two<T>(e.k - 2);
  const pair<T> start = sum_of(scale, all<T>(-0.25)), s = sum_of(start.high, product(scale, e.grown.high));
  return fast_sum_of(s.high, T((start.low + s.low) + product(scale, e.grown.low)));
}
template <Real T>
CCA_INLINE constexpr T clamped(T x, double low, double high) {  // NaN stays
  return pick(x < low, low, pick(x > high, high, x));
}
template <Real T>
CCA_INLINE constexpr T or_tiny(T x, T result) {  // x^2 can't be seen beside x
  return pick(magnitude(x) < 0x1p-55, x, result);
}
template <Real T>
CCA_INLINE constexpr pair<T> quarter_of_exp(T x) {
  CCA_EXACT
  const exponential<T> e = exponential_of(x);
  const T scale = power_of_two<T>(e.k - 2);
  const pair<T> s = fast_sum_of(all<T>(1), e.grown.high), r = fast_sum_of(s.high, T(s.low + e.grown.low));
  return {product(scale, r.high), product(scale, r.low)};
}

}  // namespace detail

template <Real T>
CCA_INLINE constexpr T exp(T x) {
  if (!detail::everywhere(detail::magnitude(x) <= 708.0)) [[unlikely]]
    return detail::lane_by_lane(
        x, [](double lane) { return detail::magnitude(lane) <= 708.0 ? exp(lane) : detail::far_exp(lane); });
  return detail::near_exp(detail::exponential_of(x));
}

// exp(x) - 1, also where exp(x) is nearly 1.
template <Real T>
CCA_INLINE constexpr T expm1(T x) {
  if (detail::is_odd_constant(x == x)) return detail::all<T>(detail::not_a_number);
  const T q = detail::quarter_of_growth(detail::clamped(x, -60, 710.5)).high;
  return detail::where(x == x, detail::or_tiny(x, detail::enlarged(q, 4)));
}

template <Real T>
CCA_INLINE constexpr T sinh(T x) {
  CCA_EXACT
  if (detail::is_odd_constant(x == x)) return detail::all<T>(detail::not_a_number);
  const T size = detail::magnitude(x);
  const detail::pair<T> q = detail::quarter_of_growth(detail::pick(size > 710.5, 710.5, size));
  const detail::pair<T> e = detail::sum_of(detail::all<T>(0.25), q.high);  // exp / 4
  const detail::pair<T> back = detail::quotient_of(q, {e.high, e.low + q.low});
  const detail::pair<T> s = detail::fast_sum_of(q.high, T(0.25 * back.high));
  const T result = detail::enlarged(T(s.high + (s.low + (q.low + 0.25 * back.low))), 2);
  return detail::where(x == x, detail::or_tiny(x, detail::with_sign_of(x, result)));
}

template <Real T>
CCA_INLINE constexpr T cosh(T x) {
  CCA_EXACT
  if (detail::is_odd_constant(x == x)) return detail::all<T>(detail::not_a_number);
  const T size = detail::magnitude(x);
  const detail::pair<T> e = detail::quarter_of_exp(detail::pick(size > 710.5, 710.5, size));
  return detail::where(x == x, detail::enlarged(T(e.high + (e.low + 0.0625 / e.high)), 2));
}

template <Real T>
CCA_INLINE constexpr T tanh(T x) {
  CCA_EXACT
  if (detail::is_odd_constant(x == x)) return detail::all<T>(detail::not_a_number);
  const T size = detail::magnitude(x), twice = 2 * detail::pick(size > 25, 25.0, size);
  const detail::pair<T> q = detail::quarter_of_growth(twice);
  const detail::pair<T> under = detail::sum_of(detail::all<T>(0.5), q.high);
  const detail::pair<T> t = detail::quotient_of(q, {under.high, under.low + q.low});
  return detail::where(x == x, detail::or_tiny(x, detail::with_sign_of(x, T(t.high + t.low))));
}

}  // namespace cca::math
