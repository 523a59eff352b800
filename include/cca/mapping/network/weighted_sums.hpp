// The weighted sums of a layer: y = W x + b, of fixed sizes, in double or float.
//
// W stands by columns, then b. Some rows at a time, whose sums stay in registers through all columns: Eigen's
// product of a matrix and a vector loads and stores them again for every few columns, and takes some 15 %
// more instructions. Without a bias (`sums`), W alone.
#pragma once

#include <cca/base/eigen.hpp>

namespace cca::detail {

template <class Number, int From, int To>
struct weighted_sums {
  static constexpr int wide = 128 / sizeof(Number);
  using output = Eigen::Matrix<Number, To, 1>;

  template <class Vector>
  [[gnu::always_inline]] static output of(const Number* weights, const Vector& x) {
    return from(weights, weights + To * From, x);
  }
  // The rows begin at those of `start`: a bias, or sums that another matrix began.
  template <class Vector>
  [[gnu::always_inline]] static output from(const Number* weights, const Number* start, const Vector& x) {
    output y;
    int row = 0;
    for (; row + wide <= To; row += wide) rows<wide>(weights, start, row, x, y);
    if constexpr (To % wide != 0) rows<To % wide>(weights, start, row, x, y);
    return y;
  }

private:
  template <int Count, class Vector>
  [[gnu::always_inline]] static void rows(
      const Number* weights, const Number* start, int row, const Vector& x, output& y) {
    using part = Eigen::Map<const Eigen::Matrix<Number, Count, 1>>;
    Eigen::Matrix<Number, Count, 1> sums = part(start + row);
    for (int j = 0; j < From; ++j) sums += x[j] * part(weights + To * j + row);
    y.template segment<Count>(row) = sums;
  }
};

}  // namespace cca::detail
