// Functions of each number of a vector, as they stand in networks: of fixed size, in double or float, without
// a branch.
//
//   elu(x, alpha)          x above 0, else alpha (exp(x) - 1)
//   leaky_relu(x, alpha)   x above 0, else alpha x
//   relu, sigmoid, silu (x sigmoid(x)), tangent (tanh), softmax
//
// All of them come from one fraction, tanh(x / 2) = n / d with n = x P(x^2) and d = Q(x^2), |x| <= 18 (in
// float 16): sigmoid = (d + n) / 2d, exp = (d + n) / (d - n), so each takes one division. In double they are
// within 1.1e-9 of the function, in float within 5e-7. Plain arithmetic: every machine gives the same. If an
// input is NaN the output is any number, and there is no status and no fault: whoever calls asks before.
// Source of the fraction: a weighted fit in the maximum norm over [0, 18] by repeated least squares (Lawson
// 1961). Clevert, Unterthiner, Hochreiter, Fast and accurate deep network learning by exponential linear
// units, 2015; Elfwing, Uchibe, Doya, Sigmoid-weighted linear units, 2017.
// Cost: some 30 instructions for each two doubles or four floats (SSE2).
#pragma once

#include <cstring>
#include <type_traits>

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

// tanh(x / 2) = above / under for |x| <= furthest.
template <class Pack>
struct half_tangent {
  static constexpr bool is_short = sizeof(number_in<Pack>) == 4;
  static constexpr double furthest = is_short ? 16 : 18;
  Pack above, under;

  [[gnu::always_inline]] explicit half_tangent(Pack x) {
    const auto c = [](double value) { return static_cast<number_in<Pack>>(value); };
    const Pack s = x * x;
    if constexpr (is_short) {
      above = ((c(0x1.7b82069ef247bp-24) * s + c(0x1.8132ab943ee7ep-14)) * s + c(0x1.0878aaef994c2p-6)) * s +
              c(0x1.ffffea981f848p-2);
      under =
          (((c(0x1.0441fd9f9e966p-30) * s + c(0x1.f115a3ef0b200p-19)) * s + c(0x1.8558b3b2d9f41p-10)) * s +
           c(0x1.d9910d5dbeff7p-4)) *
              s +
          c(1);
    } else {
      above =
          (((c(0x1.b1872a780655ep-34) * s + c(0x1.083961fa16779p-22)) * s + c(0x1.0669c84b6044dp-13)) * s +
           c(0x1.1a409c6442288p-6)) *
              s +
          c(0x1.ffffffd9a8e04p-2);
      under =
          ((((c(0x1.925a024517950p-41) * s + c(0x1.b05e544889367p-28)) * s + c(0x1.b85c50d0057bbp-18)) * s +
            c(0x1.c6300fe1239d3p-10)) *
               s +
           c(0x1.e275a239610d8p-4)) *
              s +
          c(1);
    }
    above *= x;
  }
};

template <class Pack>
[[gnu::always_inline]] inline Pack sigmoid_of(Pack x) {
  constexpr double end = half_tangent<Pack>::furthest;
  const half_tangent<Pack> t(within(x, -end, end));
  const auto half = static_cast<number_in<Pack>>(0.5);
  return half + half * t.above / t.under;
}

template <class Pack>
[[gnu::always_inline]] inline Pack tangent_of(Pack x) {
  constexpr double end = half_tangent<Pack>::furthest / 2;
  const Pack y = within(x, -end, end);
  const half_tangent<Pack> t(y + y);
  return t.above / t.under;
}

}  // namespace detail

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> elu(const numbers<Number, Size>& x, double alpha) {
  return detail::each(x, [alpha](auto some) {
    using pack = decltype(some);
    const pack down = detail::within(some, -detail::half_tangent<pack>::furthest, 0);
    const detail::half_tangent<pack> t(down);
    const pack zero{}, up = some > zero ? some : zero;
    return up + static_cast<Number>(alpha) * ((t.above + t.above) / (t.under - t.above));
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
  return detail::each(x, [](auto some) { return detail::sigmoid_of(some); });
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> silu(const numbers<Number, Size>& x) {
  return detail::each(x, [](auto some) { return some * detail::sigmoid_of(some); });
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> tangent(const numbers<Number, Size>& x) {
  return detail::each(x, [](auto some) { return detail::tangent_of(some); });
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> softmax(const numbers<Number, Size>& x) {
  const numbers<Number, Size> below = (x.array() - x.maxCoeff()).matrix();
  const numbers<Number, Size> e = detail::each(below, [](auto some) {
    using pack = decltype(some);
    const detail::half_tangent<pack> t(detail::within(some, -detail::half_tangent<pack>::furthest, 0));
    return (t.under + t.above) / (t.under - t.above);
  });
  return e / e.sum();
}

}  // namespace cca::neural
