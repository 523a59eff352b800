// Sine, cosine and tangent of an angle in radians; sine_and_cosine gives both for little more than one.
//
// Errors: at most 0.8 units in the last place (sin, cos), 1 (tan); figures of many arguments in
// docs/math.md. NaN and infinite angles give NaN. Any finite angle is reduced exactly. Templates on the
// scalar: double, float (computed in double), lanes.
//
// |x| <= 2^20 pi / 2: Cody and Waite's reduction in four parts, without a branch; beyond: Payne and Hanek's,
// with as much of 2 / pi as it takes, one lane after the other. Coefficients:
// tests/runtime/math/coefficients.sollya.
#pragma once

#include <cca/base/math/rounding.hpp>

namespace cca::math {

template <Real T>
struct sine_and_cosine_of {
  T sine, cosine;
};

namespace detail {

inline constexpr double sine_terms[] = {-0x1.5555555555555p-3, 0x1.111111111101fp-7,   -0x1.a01a019fe8de3p-13,
                                        0x1.71de3a10d6dd4p-19, -0x1.ae63f8fdc710ep-26, 0x1.60e684b29b3fcp-33,
                                        -0x1.8db5a7916f0cep-41};
inline constexpr double cosine_terms[] = {0x1.5555555555555p-5,  -0x1.6c16c16c168cap-10,
                                          0x1.a01a019f3838fp-16, -0x1.27e4fa02e3bf8p-22,
                                          0x1.1eeb57d2ffc05p-29, -0x1.907385311fb0bp-37};

// An angle is rest + quarters pi / 2, |rest| <= pi / 4. Of `quarters` only the last two bits count.
template <Real T>
struct reduced {
  pair<T> rest;
  word<T> quarters;
};

// The first three parts of pi / 2 have 33 bits, so their products are exact.
template <Real T>
CCA_INLINE constexpr reduced<T> reduce(T x) {
  CCA_EXACT
  const whole<T> k = nearest(product(x, 0x1.45f306dc9c883p-1));
  const T y = x - product(k.value, 0x1.921fb544p+0);
  const pair<T> a = sum_of(y, T(-product(k.value, 0x1.0b4611a6p-34)));
  const pair<T> b = sum_of(a.high, T(-product(k.value, 0x1.3198a2ep-69)));
  const T low = (a.low + b.low) - product(k.value, 0x1.b839a252049c1p-104);
  const T high = b.high + low;
  return {{high, (b.high - high) + low}, k.bits};
}
template <Real T>
CCA_INLINE constexpr auto can_reduce(T x) {  // no for NaN
  return magnitude(x) <= 0x1.921fb54442d18p+20;
}

// x 2 / pi modulo 4 from eight limbs of 2 / pi: 138 bits behind the point are right, and no double is nearer
// to a multiple of pi / 2 than 2^-62 of it. Finite, |x| >= 2.
[[gnu::noinline]] constexpr reduced<double> reduce_far(double x) {
  CCA_EXACT
  constexpr std::uint32_t two_over_pi[] = {
      0,          0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab,
      0xdebbc561, 0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5,
      0x2ebb4484, 0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff,
      0xde05980f, 0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7,
      0xebe5f17b, 0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab, 0xf0cfbc20};
  const auto all_bits = std::bit_cast<std::uint64_t>(x);
  const std::uint64_t m = (all_bits & 0xfffffffffffff) | 0x10000000000000;
  const int exponent = static_cast<int>(all_bits >> 52 & 0x7ff) - 1075;  // |x| = m 2^exponent
  const int first = exponent > 34 ? (exponent - 2) / 32 : 0;  // limbs before it give multiples of 4
  // m times these limbs, in ten limbs of 32 bits, the highest first.
  std::uint64_t sum[10] = {};
  for (int i = 0; i < 8; ++i) {
    const std::uint64_t limb = two_over_pi[first + i], low = limb * (m & 0xffffffff), high = limb * (m >> 32);
    sum[i + 2] += low & 0xffffffff;
    sum[i + 1] += (low >> 32) + (high & 0xffffffff);
    sum[i] += high >> 32;
  }
  for (int i = 9; i > 0; --i) sum[i - 1] += sum[i] >> 32, sum[i] &= 0xffffffff;
  const int point = 32 * (first + 7) - exponent;  // so many bits stand behind the point
  const auto bits_from = [&](int lowest) {
    std::uint64_t found = 0;
    for (int w = 0; w < 3; ++w) {
      const int limb = 9 - ((lowest >> 5) + w), shift = 32 * w - (lowest & 31);
      const std::uint64_t value = limb >= 0 && limb < 10 ? sum[limb] : 0;
      found |= shift >= 64 ? 0 : shift >= 0 ? value << shift : value >> -shift;
    }
    return found;
  };
  std::uint64_t quarters = bits_from(point) & 3, upper = bits_from(point - 64),
                lower = bits_from(point - 128);
  const bool is_above_half = upper >> 63;
  if (is_above_half) {  // to the nearest: the rest is negative
    ++quarters;
    lower = ~lower + 1;
    upper = ~upper + (lower == 0);
  }
  const int zeros = upper != 0 ? std::countl_zero(upper) : 64 + (lower != 0 ? std::countl_zero(lower) : 63);
  if (zeros >= 64) upper = lower << (zeros - 64), lower = 0;
  else if (zeros > 0) upper = upper << zeros | lower >> (64 - zeros), lower <<= zeros;
  // The rest in three parts, times pi / 2; the first has 32 bits, so its products with parts of 21 bits are
  // exact.
  const double a = static_cast<double>(upper >> 32) * 0x1p-32,
               b = static_cast<double>(upper & 0xffffffff) * 0x1p-64,
               c = static_cast<double>(lower >> 32) * 0x1p-96;
  const pair<double> s = sum_of(product(a, 0x1.921fbp+0), product(a, 0x1.5110bp-22));
  const double t =
      product(a, 0x1.18469898cc517p-44) + product(b, 0x1.921fb54442d18p+0) + product(c, 0x1.921fb54442d18p+0);
  const pair<double> r = sum_of(s.high, s.low + t);
  const double scale = power_of_two<double>(-zeros), turned = is_above_half ? -scale : scale;
  const bool is_negative = all_bits >> 63;
  return {{r.high * (is_negative ? -turned : turned), r.low * (is_negative ? -turned : turned)},
          static_cast<std::int64_t>(is_negative ? 0 - quarters : quarters)};
}

// Sine and cosine of |r| <= pi / 4, each as the sum that is rounded last.
template <Real T>
CCA_INLINE constexpr pair<T> near_sine(pair<T> r) {
  CCA_EXACT
  const T z = product(r.high, r.high);
  return {r.high,
          product(product(r.high, z), polynomial(z, sine_terms)) + product(r.low, T(1 - product(z, 0.5)))};
}
template <Real T>
CCA_INLINE constexpr pair<T> near_cosine(pair<T> r) {
  CCA_EXACT
  const T z = product(r.high, r.high), half = product(z, 0.5), w = 1 - half;
  return {w,
          ((1 - w) - half) + (product(product(z, z), polynomial(z, cosine_terms)) - product(r.high, r.low))};
}

template <Real T>
CCA_INLINE constexpr sine_and_cosine_of<T> turned(reduced<T> at) {
  CCA_EXACT
  const pair<T> s = near_sine(at.rest), c = near_cosine(at.rest);
  const word<T> sine = bits(T(s.high + s.low)), cosine = bits(T(c.high + c.low)), odd = -(at.quarters & 1);
  const word<T> first = (cosine & odd) | (sine & ~odd), second = (sine & odd) | (cosine & ~odd);
  return {from_bits<T>(first ^ ((at.quarters & 2) << 62)),
          from_bits<T>(second ^ (((at.quarters + 1) & 2) << 62))};
}
template <Real T>
CCA_INLINE constexpr T turned_tangent(reduced<T> at) {
  CCA_EXACT
  const pair<T> s0 = near_sine(at.rest), c0 = near_cosine(at.rest);
  const pair<T> s = fast_sum_of(s0.high, s0.low), c = fast_sum_of(c0.high, c0.low);
  const auto is_odd = (at.quarters & 1) != 0;
  const pair<T> over{pick(is_odd, c.high, s.high), pick(is_odd, c.low, s.low)};
  const pair<T> under{pick(is_odd, T(-s.high), c.high), pick(is_odd, T(-s.low), c.low)};
  const pair<T> q = quotient_of(over, under);
  return q.high + q.low;
}

[[gnu::noinline]] constexpr sine_and_cosine_of<double> far_sine_and_cosine(double x) {
  if (!(magnitude(x) < infinite)) return {not_a_number, not_a_number};
  return turned(reduce_far(x));
}
[[gnu::noinline]] constexpr double far_tangent(double x) {
  return magnitude(x) < infinite ? turned_tangent(reduce_far(x)) : not_a_number;
}

}  // namespace detail

// Both of one angle.
template <Real T>
CCA_INLINE constexpr sine_and_cosine_of<T> sine_and_cosine(T x) {
  if constexpr (std::same_as<T, double>)
    if (detail::is_odd_constant(detail::can_reduce(x))) return detail::far_sine_and_cosine(x);
  auto [sine, cosine] = detail::turned(detail::reduce(x));
  if (!detail::everywhere(detail::can_reduce(x))) [[unlikely]] {
    if constexpr (std::same_as<T, double>) {
      return detail::far_sine_and_cosine(x);
    } else {
      for (std::size_t i = 0; i < sizeof(T) / sizeof(double); ++i) {
        const auto of_lane = sine_and_cosine(x[i]);
        sine[i] = of_lane.sine, cosine[i] = of_lane.cosine;
      }
    }
  }
  return {detail::pick(x == 0, x, sine), cosine};
}

template <Real T>
CCA_INLINE constexpr T sin(T x) {
  return sine_and_cosine(x).sine;
}
template <Real T>
CCA_INLINE constexpr T cos(T x) {
  return sine_and_cosine(x).cosine;
}
template <Real T>
CCA_INLINE constexpr T tan(T x) {
  if (!detail::everywhere(detail::can_reduce(x))) [[unlikely]]
    return detail::lane_by_lane(
        x, [](double lane) { return detail::can_reduce(lane) ? tan(lane) : detail::far_tangent(lane); });
  return detail::pick(x == 0, x, detail::turned_tangent(detail::reduce(x)));
}

}  // namespace cca::math
