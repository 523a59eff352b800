// sqrt, cbrt, hypot, floor, ceil, round, trunc, fmod. But for fmod of a huge quotient: no branch, no table.
//
// Errors: none but rounding (sqrt, floor, ceil, round, trunc, fmod), at most 0.7 units in the last place
// (cbrt) and 0.6 (hypot); figures of many arguments in docs/math.md. sqrt of a negative number is NaN,
// fmod(x, 0) too. hypot of an infinite side is infinite, also beside NaN. Templates on the scalar: double,
// float (computed in double), lanes.
//
// sqrt makes no call: a compiler's own would make one for errno.
#pragma once

#include <cca/base/math/rounding.hpp>

namespace cca::math {
namespace detail {

// By hand: two digits of x give one of the root, and one more than a double has says how it is rounded.
constexpr double constant_square_root(double x) {
  CCA_EXACT
  if (!(x > 0) || x == infinite) return x;
  const bool is_subnormal = x < 0x1p-1022;
  const std::int64_t all = bits(is_subnormal ? x * 0x1p54 : x);
  const std::int64_t exponent = (all >> 52) - (is_subnormal ? 1023 + 54 : 1023), half = exponent >> 1;
  const std::int64_t mantissa = ((all & 0xfffffffffffff) | 0x10000000000000) << (exponent - 2 * half);
  std::int64_t root = 0, rest = 0;
  for (int digit = 52; digit >= -54; digit -= 2) {
    rest = rest << 2 | (digit >= 0 ? mantissa >> digit & 3 : 0);
    const std::int64_t taken = root << 2 | 1;
    root = root << 1 | (rest >= taken);
    if (rest >= taken) rest -= taken;
  }
  return static_cast<double>((root + 1) >> 1) * power_of_two<double>(half - 52);
}
// Of x >= 0; of others no NaN in particular.
template <Real T>
CCA_INLINE constexpr T near_sqrt(T x) {
  if constexpr (std::same_as<T, double>) {
    if (std::is_constant_evaluated()) return constant_square_root(x);
    return magnitude(cca::detail::square_root_of(x));
  } else {
    return magnitude(cca::detail::square_roots_of(x));
  }
}

}  // namespace detail

template <Real T>
CCA_INLINE constexpr T sqrt(T x) {
  return detail::where(x >= 0, detail::with_sign_of(x, detail::near_sqrt(x)));
}

namespace detail {

// A first guess of the cube root of 1 to 8, to one part in 1,400.
inline constexpr double cube_root_terms[] = {0x1.2c993c9ef6616p-1,  0x1.0d6673a64b765p-1,
                                             -0x1.138a02c6d862bp-3, 0x1.8c42d2eb49ba9p-6,
                                             -0x1.2e950db2842b4p-9, 0x1.71abdf020c951p-14};

// |x| < 2^52 is rounded by adding 2^52; larger numbers are whole.
template <Real T>
CCA_INLINE constexpr T to_whole(T size) {
  CCA_EXACT
  return (size + 0x1p52) - 0x1p52;
}

// Of sides whose squares are normal, the longer one first; less may be so small that its square is nothing.
template <Real T>
CCA_INLINE constexpr T near_hypot(T more, T less) {
  CCA_EXACT
  const T root = near_sqrt(T(product(more, more) + product(less, less)));
  const T mh = upper_26(more), lh = upper_26(less), rh = upper_26(root);
  const T low = product(T(more - mh), T(more + mh)) - product(T(root - rh), T(root + rh)) +
                product(T(less - lh), T(less + lh));
  return root + (((product(mh, mh) - product(rh, rh)) + product(lh, lh)) + low) / (2 * root);
}
[[gnu::noinline]] constexpr double far_hypot(double ax, double ay) {
  CCA_EXACT
  if (ax == infinite || ay == infinite) return infinite;
  if (!(ax == ax) || !(ay == ay)) return not_a_number;
  const double more = ax > ay ? ax : ay, less = ax > ay ? ay : ax;
  if (more == 0) return 0;
  if (more > 1) return enlarged(near_hypot(more * 0x1p-600, less * 0x1p-600), 0x1p600);
  return near_hypot(more * 0x1p600, less * 0x1p600) * 0x1p-600;
}

// x - q y for a large quotient, as by hand: y times ever smaller powers of two is taken away. 0 < y <= x,
// finite.
[[gnu::noinline]] constexpr double long_remainder(double x, double y) {
  CCA_EXACT
  const auto exponent = [](double size) {
    return size < 0x1p-1022 ? (std::bit_cast<std::int64_t>(size * 0x1p54) >> 52) - 54
                            : std::bit_cast<std::int64_t>(size) >> 52;
  };
  double rest = x;
  while (rest >= y) {
    double part = y;
    for (std::int64_t steps = exponent(rest) - exponent(y); steps > 0;) {
      const std::int64_t some = steps < 1000 ? steps : 1000;
      part *= power_of_two<double>(some), steps -= some;
    }
    if (part > rest) part *= 0.5;
    rest -= part;
  }
  return rest;
}

}  // namespace detail

template <Real T>
CCA_INLINE constexpr T trunc(T x) {
  CCA_EXACT
  const T size = detail::magnitude(x);
  if (detail::is_odd_constant(size < 0x1p52)) return detail::where(x == x, x);
  const T whole = detail::to_whole(size);
  const T down = whole - detail::pick(whole > size, 1.0, T{});
  return detail::where(x == x, detail::pick(size < 0x1p52, detail::with_sign_of(x, down), x));
}
template <Real T>
CCA_INLINE constexpr T floor(T x) {
  CCA_EXACT
  const T t = trunc(x);
  if (detail::is_odd_constant(detail::magnitude(x) < 0x1p52)) return t;
  return detail::pick(t > x, T(t - 1), t);
}
template <Real T>
CCA_INLINE constexpr T ceil(T x) {
  CCA_EXACT
  const T t = trunc(x);
  if (detail::is_odd_constant(detail::magnitude(x) < 0x1p52)) return t;
  return detail::pick(t < x, detail::with_sign_of(x, T(t + 1)), t);
}
// Halves away from zero.
template <Real T>
CCA_INLINE constexpr T round(T x) {
  CCA_EXACT
  const T t = trunc(x);
  if (detail::is_odd_constant(detail::magnitude(x) < 0x1p52)) return t;
  const T left = detail::magnitude(T(x - t));
  return detail::pick(left >= 0.5, T(t + detail::with_sign_of(x, detail::all<T>(1))), t);
}

template <Real T>
CCA_INLINE constexpr T cbrt(T x) {
  CCA_EXACT
  using namespace detail;
  if (is_odd_constant(x == x)) return all<T>(not_a_number);
  const T size = magnitude(x);
  const auto is_subnormal = size < 0x1p-1022;
  const word<T> w = bits(T(size * pick(is_subnormal, all<T>(0x1p54), all<T>(1))));
  const T exponent = number<T>(word<T>((w >> 52) - 1023));
  const whole<T> third = nearest(product(T(exponent - 1), 0x1.5555555555555p-2));
  const word<T> k = third.bits - std::bit_cast<std::int64_t>(upper_half);
  const T m = from_bits<T>(w - ((k + k + k) << 52));  // 1 to 8
  T t = polynomial(m, cube_root_terms);
  const T cube = product(product(t, t), t);
  t = product(t, T((cube + 2 * m) / (2 * cube + m)));                    // Halley: to 30 bits
  t = from_bits<T>((bits(t) + 0x20000000) & ~std::int64_t{0x3fffffff});  // its square is exact
  const T r = m / product(t, t);
  t = t + product(t, T((r - t) / (2 * t + r)));  // Newton
  const T root = t * power_of_two<T>(k) * pick(is_subnormal, all<T>(0x1p-18), all<T>(1));
  return where(x == x, pick((size > 0) & (size < infinite), with_sign_of(x, root), x));
}

template <Real T>
CCA_INLINE constexpr T hypot(T x, T y) {
  CCA_EXACT
  using namespace detail;
  const T ax = magnitude(x), ay = magnitude(y);
  const T more = pick(ax > ay, ax, ay), less = pick(ax > ay, ay, ax);
  if (!everywhere((more < 0x1p500) & (more > 0x1p-440) & (less <= more)))
      [[unlikely]] {  // squares leave the range, or there is a NaN
    if constexpr (std::same_as<T, double>) {
      return far_hypot(ax, ay);
    } else {
      for (std::size_t i = 0; i < sizeof(T) / sizeof(double); ++i) x[i] = hypot(double(ax[i]), double(ay[i]));
      return x;
    }
  }
  return near_hypot(more, less);
}

// x - q y for the whole q nearest zero; exact.
template <Real T>
CCA_INLINE constexpr T fmod(T x, T y) {
  CCA_EXACT
  using namespace detail;
  const T ax = magnitude(x), ay = magnitude(y);
  const auto is_defined = (ax < infinite) & (ay > 0);
  if (is_odd_constant(is_defined)) return all<T>(not_a_number);
  const auto is_near = (ax * 0x1p-50 < ay) & (ay > 0x1p-900) & (ay < 0x1p900);
  const T q = trunc(T(pick(is_near, ax, T{}) / pick(is_near, ay, 1.0)));
  const T qh = upper_26(q), divisor = pick(is_near, ay, T{}), dh = upper_26(divisor);
  T rest = (((ax - product(qh, dh)) - product(qh, T(divisor - dh))) - product(T(q - qh), dh)) -
           product(T(q - qh), T(divisor - dh));
  rest = pick(rest < 0, T(rest + divisor), rest);
  rest = pick(rest >= divisor, T(rest - divisor), rest);
  if (!everywhere(is_near | (ax < ay) | (is_defined == 0))) [[unlikely]] {
    if constexpr (std::same_as<T, double>) rest = long_remainder(ax, ay);
    else
      for (std::size_t i = 0; i < sizeof(T) / sizeof(double); ++i) rest[i] = fmod(ax[i], ay[i]);
  }
  rest = pick(ax < ay, ax, rest);
  return where(is_defined, with_sign_of(x, rest));
}

}  // namespace cca::math
