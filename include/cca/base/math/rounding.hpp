// What the elementary functions of math/ are made of: sums and products of two doubles with what their
// rounding left out, numbers as bits, and a choice without a branch. All of it is written once for double and
// for lanes: vectors of doubles of the compiler's (`double __attribute__((vector_size(32)))`), in which each
// lane is a number of its own.
//
// The same bits everywhere: only + - * / and square roots, which IEEE 754 rounds correctly, and integers.
// What breaks that is a product that is added before it is rounded (contraction), so every product that is
// added goes through product(), and every function begins with CCA_EXACT. -ffast-math is refused, and so are
// those of its parts that the compiler tells.
#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

#include <cca/base/inlining.hpp>

#ifdef __FAST_MATH__
#error "math.fast: with -ffast-math a program computes other bits on each machine: compile without it"
#elif defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__) || \
    __FINITE_MATH_ONLY__
#error \
    "math.fast: a part of -ffast-math is on, so a program computes other bits, or wrong ones: compile without it"
#elif defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ == 2 || __FLT_EVAL_METHOD__ < 0)
#error "math.fast: doubles are computed with more bits here, as by -mfpmath=387: compile with -mfpmath=sse"
#endif

namespace cca::math {

// A double, or lanes of doubles.
template <class T> concept Real = std::same_as<T, double> || (!std::is_class_v<T> && requires(T lanes) {
                                    lanes + lanes;
                                    requires std::same_as<std::remove_cvref_t<decltype(lanes[0])>, double>;
                                  });

namespace detail {

using cca::detail::kept;

template <Real T>
struct word_of {
  using type = decltype(T{} < T{});  // integers with a sign, as long as the doubles
};
template <>
struct word_of<double> {
  using type = std::int64_t;
};
template <Real T>
using word = typename word_of<T>::type;

template <Real T>
CCA_INLINE constexpr word<T> bits(T x) {
  return std::bit_cast<word<T>>(x);
}
template <Real T>
CCA_INLINE constexpr T from_bits(word<T> x) {
  return std::bit_cast<T>(x);
}

// The number in each lane. Not for -0.
template <Real T>
CCA_INLINE constexpr T all(double x) {
  if constexpr (std::same_as<T, double>) return x;
  else return T{} + x;
}

// Of each lane the one or the other; one of them may be the same number in all lanes. A condition is what a
// comparison gives.
template <class Condition, Real Yes, Real No>
CCA_INLINE constexpr auto pick(Condition condition, Yes yes, No no) {
  if constexpr (std::same_as<Yes, No>) return condition ? yes : no;
  else if constexpr (std::same_as<Yes, double>) return condition ? all<No>(yes) : no;
  else return condition ? yes : all<Yes>(no);
}

template <class Condition>
CCA_INLINE constexpr bool everywhere(Condition condition) {
  if constexpr (std::integral<Condition>) {
    return condition;
  } else {
    constexpr int lanes = sizeof(condition) / sizeof(condition[0]);
    if constexpr (lanes == 1) return condition[0] != 0;
    else if constexpr (lanes == 2) return (condition[0] & condition[1]) != 0;
    else {
      const auto [first, second] =
          cca::detail::halves_of(condition, std::make_integer_sequence<int, lanes / 2>{});
      return everywhere(first & second);
    }
  }
}

inline constexpr std::int64_t sign_bit = std::int64_t(std::uint64_t{1} << 63);

template <Real T>
CCA_INLINE constexpr T magnitude(T x) {
  return from_bits<T>(bits(x) & ~sign_bit);
}
template <Real T>
CCA_INLINE constexpr T with_sign_of(T sign, T x) {
  return from_bits<T>((bits(x) & ~sign_bit) | (bits(sign) & sign_bit));
}

inline constexpr double infinite = std::bit_cast<double>(std::int64_t{0x7ff} << 52);
// One NaN for all: sign and payload of others differ between machines.
inline constexpr double not_a_number = std::bit_cast<double>(std::int64_t{0x7ff8} << 48);
// The result where a condition holds, else that NaN. Chosen as bits: to a compiler all NaNs are the same.
template <Real T, class Condition>
CCA_INLINE constexpr T where(Condition condition, T result) {
  if constexpr (std::same_as<T, double>) return from_bits<T>(condition ? bits(result) : bits(not_a_number));
  else return from_bits<T>(condition ? bits(result) : word<T>{} + bits(not_a_number));
}

// A constant expression may compute nothing that is NaN or too large, not even beside its result. So a
// function asks whether its argument must be treated apart there; at run time none is.
template <class Condition>
CCA_INLINE constexpr bool is_odd_constant(Condition is_usual) {
  return std::is_constant_evaluated() && !everywhere(is_usual);
}
// x times a power of two.
template <Real T>
CCA_INLINE constexpr T enlarged(T x, double power) {
  CCA_EXACT
  if (is_odd_constant(magnitude(x) <= std::numeric_limits<double>::max() / power))
    return with_sign_of(x, all<T>(infinite));
  return x * power;
}

// ---- a number in two parts: high is what the sum of both rounds to ----

template <Real T>
struct pair {
  T high, low;
};

template <Real T>
CCA_INLINE constexpr T product(T a, T b) {
  CCA_EXACT
  return kept<T>(a * b);
}
template <Real T>
  requires(!std::same_as<T, double>)
CCA_INLINE constexpr T product(T a, double b) {
  return product(a, all<T>(b));
}

// a + b (Knuth); fast_sum_of: where a is the larger one (Dekker).
template <Real T>
CCA_INLINE constexpr pair<T> sum_of(T a, T b) {
  CCA_EXACT
  const T s = a + b, t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}
template <Real T>
CCA_INLINE constexpr pair<T> fast_sum_of(T a, T b) {
  CCA_EXACT
  const T s = a + b;
  return {s, b - (s - a)};
}

// The first 26 or 21 bits: the product of two such numbers is exact.
template <Real T>
CCA_INLINE constexpr T upper_26(T x) {
  return from_bits<T>(bits(x) & ~std::int64_t{0x7ffffff});
}
template <Real T>
CCA_INLINE constexpr T upper_21(T x) {
  return from_bits<T>(bits(x) & ~std::int64_t{0xffffffff});
}

// a / b: the quotient, and what is left of a over b.
template <Real T>
CCA_INLINE constexpr pair<T> quotient_of(pair<T> a, pair<T> b) {
  CCA_EXACT
  const T q = a.high / b.high, qh = upper_26(q), bh = upper_26(b.high), bl = (b.high - bh) + b.low;
  return {q,
          ((((a.high - product(qh, bh)) - product(qh, bl)) - product(T(q - qh), b.high)) + a.low) / b.high};
}

// ---- polynomials, integers, powers of two ----

// f of each lane.
template <Real T>
CCA_INLINE constexpr T lane_by_lane(T x, auto f) {
  if constexpr (std::same_as<T, double>) {
    return f(x);
  } else {
    for (std::size_t i = 0; i < sizeof(T) / sizeof(double); ++i) x[i] = f(x[i]);
    return x;
  }
}

// c[0] + c[1] x + ..., by Horner's rule. Not a loop, which would stay one.
template <Real T, std::size_t N, std::size_t... I>
CCA_INLINE constexpr T horner(T x, const double (&c)[N], std::index_sequence<I...>) {
  CCA_EXACT
  T r = all<T>(c[N - 1]);
  ((r = product(r, x) + c[N - 2 - I]), ...);
  return r;
}
template <Real T, std::size_t N>
CCA_INLINE constexpr T polynomial(T x, const double (&c)[N]) {
  return horner(x, c, std::make_index_sequence<N - 1>{});
}

// The nearest integer of |x| < 2^51, ties to even, and the same as an integer in its lowest 51 bits.
template <Real T>
struct whole {
  T value;
  word<T> bits;
};
inline constexpr double upper_half = 0x1.8p52;
template <Real T>
CCA_INLINE constexpr whole<T> nearest(T x) {
  CCA_EXACT
  const T t = x + upper_half;
  return {t - upper_half, bits(t)};
}
// An integer below 2^51 as a number.
template <Real T>
CCA_INLINE constexpr T number(word<T> k) {
  CCA_EXACT
  return from_bits<T>(k + std::bit_cast<std::int64_t>(upper_half)) - upper_half;
}

// 2^k, -1022 <= k <= 1023. Only the lowest bits of k count.
template <Real T>
CCA_INLINE constexpr T power_of_two(word<T> k) {
  return from_bits<T>((k + 1023) << 52);
}

}  // namespace detail
}  // namespace cca::math
