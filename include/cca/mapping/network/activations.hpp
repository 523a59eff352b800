// Functions of each number of a vector, as they stand in networks: of fixed size, in double or float, without
// a branch.
//
//   elu(x, alpha)          x above 0, else alpha (exp(x) - 1)
//   leaky_relu(x, alpha)   x above 0, else alpha x
//   relu, sigmoid, silu (x sigmoid(x)), tangent (tanh), softmax
//
// All of them come from one fraction, tanh(x / 2) = n / d with n = x P(x^2) and d = Q(x^2), |x| <= 18:
// sigmoid = (d + n) / 2d, exp = (d + n) / (d - n), so each takes one division. In double they are within
// 1.1e-9 of the function, in float within 3e-7. Plain arithmetic: every machine gives the same. NaN may
// become any number: whoever calls asks before.
// Source of the fraction: a weighted fit in the maximum norm over [0, 18] by repeated least squares (Lawson
// 1961). Clevert, Unterthiner, Hochreiter, Fast and accurate deep network learning by exponential linear
// units, 2015; Elfwing, Uchibe, Doya, Sigmoid-weighted linear units, 2017.
// Cost: some 30 instructions for each two doubles or four floats (SSE2).
#pragma once

#include <cca/base/eigen.hpp>

namespace cca::neural {

template <class Number, int Size>
using numbers = Eigen::Matrix<Number, Size, 1>;

namespace detail {

// Some numbers at a time, so that all steps of one stay in registers.
template <class Number, int Size, class F>
[[gnu::always_inline]] inline numbers<Number, Size> each(const numbers<Number, Size>& x, F f) {
  constexpr int wide = 32 / sizeof(Number);
  numbers<Number, Size> y;
  int i = 0;
  for (; i + wide <= Size; i += wide)
    y.template segment<wide>(i) = f(Eigen::Array<Number, wide, 1>(x.template segment<wide>(i).array()));
  for (; i < Size; ++i) y.template segment<1>(i) = f(Eigen::Array<Number, 1, 1>(x[i]));
  return y;
}

// tanh(x / 2) = above / under for |x| <= 18.
template <class Array>
struct half_tangent {
  Array above, under;

  [[gnu::always_inline]] explicit half_tangent(const Array& x) {
    using number = typename Array::Scalar;
    const auto c = [](double value) { return static_cast<number>(value); };
    const Array s = x * x;
    above = (((c(0x1.b1872a780655ep-34) * s + c(0x1.083961fa16779p-22)) * s + c(0x1.0669c84b6044dp-13)) * s +
             c(0x1.1a409c6442288p-6)) *
                s +
            c(0x1.ffffffd9a8e04p-2);
    above *= x;
    under = ((((c(0x1.925a024517950p-41) * s + c(0x1.b05e544889367p-28)) * s + c(0x1.b85c50d0057bbp-18)) * s +
              c(0x1.c6300fe1239d3p-10)) *
                 s +
             c(0x1.e275a239610d8p-4)) *
                s +
            c(1);
  }
};

template <class Array>
[[gnu::always_inline]] inline Array within(const Array& x, double least, double most) {
  using number = typename Array::Scalar;
  return x.min(static_cast<number>(most)).max(static_cast<number>(least));
}

template <class Array>
[[gnu::always_inline]] inline Array sigmoid_of(const Array& x) {
  using number = typename Array::Scalar;
  const half_tangent<Array> t(within(x, -18, 18));
  return static_cast<number>(0.5) + static_cast<number>(0.5) * t.above / t.under;
}

template <class Array>
[[gnu::always_inline]] inline Array tangent_of(const Array& x) {
  using number = typename Array::Scalar;
  const half_tangent<Array> t(static_cast<number>(2) * within(x, -9, 9));
  return t.above / t.under;
}

}  // namespace detail

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> elu(const numbers<Number, Size>& x, double alpha) {
  return detail::each(x, [alpha](const auto& part) {
    using array = std::remove_cvref_t<decltype(part)>;
    const detail::half_tangent<array> t(detail::within(part, -18, 0));
    const array down = (t.above + t.above) / (t.under - t.above);
    const array up = part.max(static_cast<Number>(0));
    return array(up + static_cast<Number>(alpha) * down);
  });
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> relu(const numbers<Number, Size>& x) {
  return detail::each(x, [](const auto& part) {
    return std::remove_cvref_t<decltype(part)>(part.max(static_cast<Number>(0)));
  });
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> leaky_relu(const numbers<Number, Size>& x, double alpha) {
  return detail::each(x, [alpha](const auto& part) {
    const Number zero = 0;
    return std::remove_cvref_t<decltype(part)>(part.max(zero) + static_cast<Number>(alpha) * part.min(zero));
  });
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> sigmoid(const numbers<Number, Size>& x) {
  return detail::each(x, [](const auto& part) { return detail::sigmoid_of(part); });
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> silu(const numbers<Number, Size>& x) {
  return detail::each(x, [](const auto& part) {
    return std::remove_cvref_t<decltype(part)>(part * detail::sigmoid_of(part));
  });
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> tangent(const numbers<Number, Size>& x) {
  return detail::each(x, [](const auto& part) { return detail::tangent_of(part); });
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> softmax(const numbers<Number, Size>& x) {
  const numbers<Number, Size> below = (x.array() - x.maxCoeff()).matrix();
  const numbers<Number, Size> e = detail::each(below, [](const auto& part) {
    using array = std::remove_cvref_t<decltype(part)>;
    const detail::half_tangent<array> t(detail::within(part, -18, 0));
    return array((t.under + t.above) / (t.under - t.above));
  });
  return e / e.sum();
}

}  // namespace cca::neural
