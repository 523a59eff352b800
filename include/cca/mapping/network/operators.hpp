// Operators of networks on vectors of fixed size, in double or float: what cca-policy writes calls them.
//
//   vector<Size>(at)          numbers that stand in the weights
//   dense<To>(weights, x)     W x + b; product<To>(weights, x): W x
//   plus, minus, times, over  number by number, with another vector or with one number for all
//   part<From, Size>(x)       Size numbers from From on; every<From, Step, Size>(x): each Step-th of them
//   chosen<Indices...>(x)     these numbers, in this order
//   joined(a, b, ...)         one after the other
//   layer_norm(x, epsilon)    (x - mean) / sqrt(variance + epsilon)
//   length, limited, ...      norms and bounds
//
// If an input is NaN or infinite the output is NaN or any number; there is no status and no fault.
// No allocation, no branch on numbers. Example: tests/runtime/policies/networks.cpp.
#pragma once

#include <cmath>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/mapping/network/activations.hpp>
#include <cca/mapping/network/weighted_sums.hpp>

namespace cca::neural {

template <int Size, class Number>
[[gnu::always_inline]] inline numbers<Number, Size> vector(const Number* at) {
  return Eigen::Map<const numbers<Number, Size>>(at);
}

template <int To, class Number, int From>
[[gnu::always_inline]] inline numbers<Number, To> dense(const Number* weights,
                                                        const numbers<Number, From>& x) {
  return cca::detail::weighted_sums<Number, From, To>::of(weights, x);
}
template <int To, class Number, int From>
[[gnu::always_inline]] inline numbers<Number, To> product(const Number* weights,
                                                          const numbers<Number, From>& x) {
  const numbers<Number, To> zero = numbers<Number, To>::Zero();
  return cca::detail::weighted_sums<Number, From, To>::from(weights, zero.data(), x);
}

namespace detail {
// One number stands for all.
template <int Size, class Number, int Of>
[[gnu::always_inline]] inline numbers<Number, Size> spread(const numbers<Number, Of>& x) {
  static_assert(Of == Size || Of == 1);
  if constexpr (Of == Size) return x;
  else return numbers<Number, Size>::Constant(x[0]);
}
template <int A, int B>
inline constexpr int larger = A > B ? A : B;
}  // namespace detail

template <class Number, int A, int B>
[[gnu::always_inline]] inline auto plus(const numbers<Number, A>& a, const numbers<Number, B>& b) {
  constexpr int size = detail::larger<A, B>;
  return numbers<Number, size>(detail::spread<size>(a) + detail::spread<size>(b));
}
template <class Number, int A, int B>
[[gnu::always_inline]] inline auto minus(const numbers<Number, A>& a, const numbers<Number, B>& b) {
  constexpr int size = detail::larger<A, B>;
  return numbers<Number, size>(detail::spread<size>(a) - detail::spread<size>(b));
}
template <class Number, int A, int B>
[[gnu::always_inline]] inline auto times(const numbers<Number, A>& a, const numbers<Number, B>& b) {
  constexpr int size = detail::larger<A, B>;
  return numbers<Number, size>(detail::spread<size>(a).cwiseProduct(detail::spread<size>(b)));
}
template <class Number, int A, int B>
[[gnu::always_inline]] inline auto over(const numbers<Number, A>& a, const numbers<Number, B>& b) {
  constexpr int size = detail::larger<A, B>;
  return numbers<Number, size>(detail::spread<size>(a).cwiseQuotient(detail::spread<size>(b)));
}

template <int From, int Step, int Size, class Number, int Of>
[[gnu::always_inline]] inline numbers<Number, Size> every(const numbers<Number, Of>& x) {
  static_assert(From >= 0 && From < Of && From + Step * (Size - 1) >= 0 && From + Step * (Size - 1) < Of);
  numbers<Number, Size> y;
  for (int i = 0; i < Size; ++i) y[i] = x[From + Step * i];
  return y;
}
template <int From, int Size, class Number, int Of>
[[gnu::always_inline]] inline numbers<Number, Size> part(const numbers<Number, Of>& x) {
  return every<From, 1, Size>(x);
}
template <int... Indices, class Number, int Of>
[[gnu::always_inline]] inline numbers<Number, static_cast<int>(sizeof...(Indices))> chosen(
    const numbers<Number, Of>& x) {
  static_assert(((Indices >= 0 && Indices < Of) && ...));
  numbers<Number, static_cast<int>(sizeof...(Indices))> y;
  int at = 0;
  ((y[at++] = x[Indices]), ...);
  return y;
}
template <class Number, int... Sizes>
[[gnu::always_inline]] inline numbers<Number, (Sizes + ...)> joined(const numbers<Number, Sizes>&... parts) {
  numbers<Number, (Sizes + ...)> y;
  int at = 0;
  (void)((y.template segment<Sizes>(at) = parts, at += Sizes), ...);
  return y;
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> layer_norm(const numbers<Number, Size>& x,
                                                               double epsilon) {
  const numbers<Number, Size> off = (x.array() - math::sum(x) / static_cast<Number>(Size)).matrix();
  const Number variance = math::squared_norm(off) / static_cast<Number>(Size);
  return off / math::sqrt(variance + static_cast<Number>(epsilon));
}

template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, 1> mean(const numbers<Number, Size>& x) {
  return numbers<Number, 1>(math::sum(x) / static_cast<Number>(Size));
}
template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, 1> total(const numbers<Number, Size>& x) {
  return numbers<Number, 1>(math::sum(x));
}
template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, 1> length(const numbers<Number, Size>& x) {
  return numbers<Number, 1>(math::sqrt(math::squared_norm(x)));
}
template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> root(const numbers<Number, Size>& x) {
  return x.cwiseSqrt();
}
template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> square(const numbers<Number, Size>& x) {
  return x.cwiseProduct(x);
}
template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> magnitude(const numbers<Number, Size>& x) {
  return x.cwiseAbs();
}
template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> negative(const numbers<Number, Size>& x) {
  return -x;
}
template <class Number, int Size>
[[gnu::always_inline]] inline numbers<Number, Size> limited(const numbers<Number, Size>& x,
                                                            double least,
                                                            double most) {
  return x.cwiseMax(static_cast<Number>(least)).cwiseMin(static_cast<Number>(most));
}

}  // namespace cca::neural
