// sqrt, cbrt, hypot, floor, ceil, round, trunc, fmod. But for fmod of a huge quotient: no branch, no table.
//
// Errors: none but rounding (sqrt, floor, ceil, round, trunc, fmod), at most 0.7 units in the last place
// (cbrt) and 0.6 (hypot); figures of many arguments in docs/math.md. sqrt of a negative number is NaN,
// fmod(x, 0) too. hypot of an infinite side is infinite, also beside NaN. Templates on the scalar: double,
// float (computed in double), lanes.
//
// sqrt makes no call: a compiler's own would make one for errno. sqrt(-0) is 0: without its sign, the NaN of
// a negative number is the same on all machines.
#pragma once

#include <cca/base/math/rounding.hpp>

namespace cca::math {
namespace detail {

// By Newton's rule from above; what is left is then less than half a unit, and there are no ties.
constexpr double constant_square_root(double x) {
  CCA_EXACT
  if (!(x > 0) || x == infinite) return x == 0 || x > 0 ? magnitude(x) : not_a_number;
  double scale = 1;
  for (; x < 1; scale *= 0.5) x *= 4;
  for (; x >= 4; scale *= 2) x *= 0.25;
  double root = 2;
  for (double next = (root + x / root) / 2; next < root; next = (root + x / root) / 2) root = next;
  return (root + rest_of_square(x, root) / (2 * root)) * scale;
}

}  // namespace detail

template <Real T>
CCA_INLINE constexpr T sqrt(T x) {
  if constexpr (std::same_as<T, double>) {
    if (std::is_constant_evaluated()) return detail::constant_square_root(x);
    return detail::magnitude(cca::detail::square_root_of(x));
  } else {
    return detail::magnitude(cca::detail::square_roots_of(x));
  }
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
  const T root = sqrt(T(product(more, more) + product(less, less)));
  const T mh = upper_26(more), lh = upper_26(less), rh = upper_26(root);
  const T low = product(T(more - mh), T(more + mh)) - product(T(root - rh), T(root + rh)) +
                product(T(less - lh), T(less + lh));
  return root + (((product(mh, mh) - product(rh, rh)) + product(lh, lh)) + low) / (2 * root);
}
[[gnu::noinline]] constexpr double far_hypot(double ax, double ay) {
  if (ax == infinite || ay == infinite) return infinite;
  if (!(ax == ax) || !(ay == ay)) return not_a_number;
  const double more = ax > ay ? ax : ay, less = ax > ay ? ay : ax;
  if (more == 0) return 0;
  if (more > 1) return near_hypot(more * 0x1p-600, less * 0x1p-600) * 0x1p600;
  return near_hypot(more * 0x1p600, less * 0x1p600) * 0x1p-600;
}

// x - q y for a large quotient, as by hand: y times ever smaller powers of two is taken away. 0 < y <= x,
// finite.
[[gnu::noinline]] constexpr double long_remainder(double x, double y) {
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
  const T size = detail::magnitude(x), whole = detail::to_whole(size);
  const T down = whole - detail::pick(whole > size, 1.0, T{});
  return detail::where(x == x, detail::pick(size < 0x1p52, detail::with_sign_of(x, down), x));
}
template <Real T>
CCA_INLINE constexpr T floor(T x) {
  CCA_EXACT
  const T t = trunc(x);
  return detail::pick(t > x, T(t - 1), t);
}
template <Real T>
CCA_INLINE constexpr T ceil(T x) {
  CCA_EXACT
  const T t = trunc(x);
  return detail::pick(t < x, detail::with_sign_of(x, T(t + 1)), t);
}
// Halves away from zero.
template <Real T>
CCA_INLINE constexpr T round(T x) {
  CCA_EXACT
  const T t = trunc(x), left = detail::magnitude(T(x - t));
  return detail::pick(left >= 0.5, T(t + detail::with_sign_of(x, detail::all<T>(1))), t);
}

template <Real T>
CCA_INLINE constexpr T cbrt(T x) {
  CCA_EXACT
  using namespace detail;
  const T size = magnitude(x);
  const auto is_subnormal = size < 0x1p-1022;
  const word<T> w = bits(pick(is_subnormal, T(size * 0x1p54), size));
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
  const auto is_near = (ax < ay * 0x1p50) & (ay > 0x1p-900) & (ay < 0x1p900);
  const T q = trunc(T(pick(is_near, ax, T{}) / pick(is_near, ay, 1.0)));
  const T qh = upper_26(q), divisor = pick(is_near, ay, T{}), dh = upper_26(divisor);
  T rest = (((ax - product(qh, dh)) - product(qh, T(divisor - dh))) - product(T(q - qh), dh)) -
           product(T(q - qh), T(divisor - dh));
  rest = pick(rest < 0, T(rest + ay), rest);
  rest = pick(rest >= ay, T(rest - ay), rest);
  const auto is_defined = (ax < infinite) & (ay > 0);
  if (!everywhere(is_near | (ax < ay) | (is_defined == 0))) [[unlikely]] {
    if constexpr (std::same_as<T, double>) rest = long_remainder(ax, ay);
    else
      for (std::size_t i = 0; i < sizeof(T) / sizeof(double); ++i) rest[i] = fmod(ax[i], ay[i]);
  }
  rest = pick(ax < ay, ax, rest);
  return where(is_defined, with_sign_of(x, rest));
}

}  // namespace cca::math
