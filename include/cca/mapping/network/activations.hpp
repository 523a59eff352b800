// Functions of each number of a vector, as they stand in networks: of fixed size, in double or float, without
// a branch.
//
//   elu(x, alpha)          x above 0, else alpha (exp(x) - 1)
//   leaky_relu(x, alpha)   x above 0, else alpha x
//   relu, sigmoid, silu (x sigmoid(x)), tangent (tanh), softmax
//
// All but relu come from exp(x) = 2^k exp(r), |r| <= log(2) / 2, with a polynomial of exp(r), and have at
// most one division. The largest errors, of 10^6 numbers from 1e-36 to 1e12 and of the ends
// (tests/runtime/mapping/ activations.cpp), as a part of the function, or absolute:
//
//                float              double
//   sigmoid      1.8e-7             4e-12     down to x = -87; below, it is 1.6e-38 instead of less
//   silu         2.2e-7             4e-12     the same: there it is within 1e-26
//   elu          9.2e-8             1e-11     of alpha = 1
//   tangent      1.8e-7             1.2e-11   odd to the last bit
//   softmax      3e-7 (absolute)    1e-12 (absolute)
//
// Plain arithmetic: every machine gives the same. If an input is NaN the output is any number, and there is
// no status and no fault: whoever calls asks before. Source of the polynomials:
// tests/runtime/math/coefficients.sollya. Clevert, Unterthiner, Hochreiter, Fast and accurate deep network
// learning by exponential linear units, 2015; Elfwing, Uchibe, Doya, Sigmoid-weighted linear units, 2017.
// Cost: some 25 instructions for each four floats or two doubles (SSE2), 30 of sigmoid, silu and tangent.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include <cca/base/math/reductions.hpp>
#include <cca/base/eigen.hpp>

namespace cca::neural {

template <class Number, int Size>
using numbers = Eigen::Matrix<Number, Size, 1>;

namespace detail {

// As many numbers as one register of 16 bytes holds, computed with at once.
template <class Number>
struct pack_of {
  using type [[gnu::vector_size(16)]] = Number;
};
template <class Number>
using pack = typename pack_of<Number>::type;

template <class Number, int Size, class F>
[[gnu::always_inline]] inline numbers<Number, Size> each(const numbers<Number, Size>& x, F f) {
  constexpr int wide = 16 / sizeof(Number);
  numbers<Number, Size> y;
  int i = 0;
  for (; i + wide <= Size; i += wide) {
    pack<Number> some;
    std::memcpy(&some, x.data() + i, sizeof some);
    some = f(some);
    std::memcpy(y.data() + i, &some, sizeof some);
  }
  if constexpr (Size % wide != 0) {
    pack<Number> rest{};
    std::memcpy(&rest, x.data() + i, sizeof(Number) * (Size % wide));
    rest = f(rest);
    std::memcpy(y.data() + i, &rest, sizeof(Number) * (Size % wide));
  }
  return y;
}

template <class Pack>
using number_in = std::remove_cvref_t<decltype(Pack{}[0])>;
template <class Pack>
[[gnu::always_inline]] inline Pack all(double value) {
  return Pack{} + static_cast<number_in<Pack>>(value);
}
// NaN becomes `least` or stays.
template <class Pack>
[[gnu::always_inline]] inline Pack within(Pack x, double least, double most) {
  const Pack low = all<Pack>(least), high = all<Pack>(most);
  x = x < high ? x : high;
  return x > low ? x : low;
}

// exp(x) = power + power grown, where power = 2^k and grown = exp(x - k log 2) - 1. `Far`: also of such x
// that k log 2 must be known to more digits than a float has.
template <class Pack, bool Far = false>
struct growth {
  using number = number_in<Pack>;
  static constexpr bool is_short = sizeof(number) == 4;
  using word = std::conditional_t<is_short, std::int32_t, std::int64_t>;
  using words = typename pack_of<word>::type;
  Pack power, grown;

  // |x| <= 87.
  [[gnu::always_inline]] explicit growth(Pack x) {
    const auto c = [](double value) { return static_cast<number>(value); };
    // Adding this leaves k, as the exponent of 2^k, in the lowest bits.
    constexpr double shift = is_short ? 0x1.8p23 + 127 : 0x1.8p52 + 1023;
    const Pack shifted = x * c(0x1.71547652b82fep+0) + c(shift), k = shifted - c(shift);
    power = std::bit_cast<Pack>(std::bit_cast<words>(shifted) << (is_short ? 23 : 52));
    Pack r, terms;
    if constexpr (is_short && Far) r = (x - k * c(0x1.62e4p-1)) - k * c(0x1.7f7d1cp-20);
    else r = x - k * c(0x1.62e42fefa39efp-1);
    if constexpr (is_short)
      terms =
          (((c(0x1.6ca98ep-10) * r + c(0x1.120abep-7)) * r + c(0x1.55556cp-5)) * r + c(0x1.5554dep-3)) * r +
          c(0x1p-1);
    else
      terms =
          (((((c(0x1.a06cd7f0c470ap-16) * r + c(0x1.a151262df4ef3p-13)) * r + c(0x1.6c16fd4b4f49dp-10)) * r +
             c(0x1.1110c66328ae4p-7)) *
                r +
            c(0x1.555555316d621p-5)) *
               r +
           c(0x1.555555673cb12p-3)) *
              r +
          c(0x1.0000000004976p-1);
    grown = r * r * terms + r;
  }
  [[gnu::always_inline]] Pack value() const { return power * grown + power; }
  [[gnu::always_inline]] Pack minus_one() const { return power * grown + (power - static_cast<number>(1)); }
};

// sigmoid(x) = of / all. Above 40 it is 1.
template <class Pack>
struct odds {
  Pack of, all;
  [[gnu::always_inline]] explicit odds(Pack x)
      : of(growth<Pack, true>(within(x, -87, 40)).value()), all(of + static_cast<number_in<Pack>>(1)) {}
};
// From -|x|, so that it is odd to the last bit.
template <class Pack>
[[gnu::always_inline]] inline Pack tangent_of(Pack x) {
  using words = typename growth<Pack>::words;
  const words sign = std::bit_cast<words>(-Pack{}), of_x = std::bit_cast<words>(x);
  const Pack low = all<Pack>(-20), y = std::bit_cast<Pack>(of_x | sign), below = y > low ? y : low;
  const Pack e = growth<Pack>(below + below).minus_one(), t = e / (e + static_cast<number_in<Pack>>(2));
  return std::bit_cast<Pack>(std::bit_cast<words>(t) ^ (~of_x & sign));
}

}  // namespace detail

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> elu(const numbers<Number, Size>& x, double alpha) {
  return detail::each(x, [alpha](auto some) {
    using pack = decltype(some);
    const pack zero{}, up = some > zero ? some : zero;
    return up + static_cast<Number>(alpha) * detail::growth<pack>(detail::within(some, -40, 0)).minus_one();
  });
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> relu(const numbers<Number, Size>& x) {
  return x.cwiseMax(Number{0});
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> leaky_relu(const numbers<Number, Size>& x, double alpha) {
  return x.cwiseMax(Number{0}) + static_cast<Number>(alpha) * x.cwiseMin(Number{0});
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> sigmoid(const numbers<Number, Size>& x) {
  return detail::each(x, [](auto some) {
    const detail::odds odds(some);
    return odds.of / odds.all;
  });
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> silu(const numbers<Number, Size>& x) {
  return detail::each(x, [](auto some) {
    const detail::odds odds(some);
    return some * odds.of / odds.all;
  });
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> tangent(const numbers<Number, Size>& x) {
  return detail::each(x, [](auto some) { return detail::tangent_of(some); });
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> softmax(const numbers<Number, Size>& x) {
  const numbers<Number, Size> below = (x.array() - x.maxCoeff()).matrix();
  const numbers<Number, Size> e = detail::each(below, [](auto some) {
    return detail::growth<decltype(some), true>(detail::within(some, -87, 0)).value();
  });
  return e / math::sum(e);
}

}  // namespace cca::neural
