// Symmetric positive matrices of a fixed size: solution and inverse, without Eigen's decompositions, which
// add in the order of the machine's packets, and which the core does not include.
//
// `positive_matrix` is a Cholesky decomposition of a positive definite matrix; of another one its results are
// not finite. `generalised_inverse` is for positive semidefinite ones, always finite: rows and columns with
// NaN or infinity, and those that come after them, may be zero.
// Cost: n^3 / 6 products for the decomposition, n^2 for a solution; nothing allocates.
// Source: Golub and Van Loan, Matrix Computations, 2013, section 4.2; Goodnight, A Tutorial on the SWEEP
// Operator, The American Statistician 33(3), 1979.
#pragma once

#include <cmath>

#include <cca/base/eigen.hpp>
#include <cca/base/math/roots.hpp>

namespace cca::detail {

template <int Size>
class positive_matrix {
public:
  using matrix = Eigen::Matrix<double, Size, Size>;

  explicit positive_matrix(const matrix& a) : l(a) {
    for (int j = 0; j < Size; ++j) {
      for (int k = 0; k < j; ++k)
        for (int i = j; i < Size; ++i) l(i, j) -= l(i, k) * l(j, k);
      inverse[j] = 1 / math::sqrt(l(j, j));
      for (int i = j; i < Size; ++i) l(i, j) *= inverse[j];
    }
  }

  // A^-1 b, for a vector or each column.
  template <int Columns>
  Eigen::Matrix<double, Size, Columns> solve(const Eigen::Matrix<double, Size, Columns>& b) const {
    return backward(forward(b));
  }
  // L^-1 b and L^-T b, where A = L L^T.
  template <int Columns>
  Eigen::Matrix<double, Size, Columns> forward(Eigen::Matrix<double, Size, Columns> b) const {
    for (int c = 0; c < Columns; ++c)
      for (int j = 0; j < Size; ++j) {
        b(j, c) *= inverse[j];
        for (int i = j + 1; i < Size; ++i) b(i, c) -= l(i, j) * b(j, c);
      }
    return b;
  }
  template <int Columns>
  Eigen::Matrix<double, Size, Columns> backward(Eigen::Matrix<double, Size, Columns> b) const {
    for (int c = 0; c < Columns; ++c)
      for (int j = Size - 1; j >= 0; --j) {
        for (int i = j + 1; i < Size; ++i) b(j, c) -= l(i, j) * b(i, c);
        b(j, c) *= inverse[j];
      }
    return b;
  }

  // The diagonal of L, from 1e-12: else A is not positive definite, or too small to tell.
  bool is_sound() const {
    for (int i = 0; i < Size; ++i)
      if (!(l(i, i) >= 1e-12)) return false;  // NaN, too
    return true;
  }
  double diagonal(int i) const { return l(i, i); }

private:
  matrix l;  // its lower triangle
  Eigen::Matrix<double, Size, 1> inverse;
};

// A symmetric G with A G A = A to rounding; the inverse if A has one. Rows and columns that depend on others,
// to `threshold` of their own size, are zero in G, and so are those whose size is below 1e-200.
template <int Size>
Eigen::Matrix<double, Size, Size> generalised_inverse(Eigen::Matrix<double, Size, Size> a,
                                                      double threshold = 1e-10) {
  using vector = Eigen::Matrix<double, Size, 1>;
  vector scale;
  for (int i = 0; i < Size; ++i) scale[i] = a(i, i) > 1e-200 ? 1 / math::sqrt(a(i, i)) : 0;
  a = scale.asDiagonal() * a * scale.asDiagonal();
  Eigen::Matrix<bool, Size, 1> done = Eigen::Matrix<bool, Size, 1>::Constant(false);
  for (int step = 0; step < Size; ++step) {
    int k = -1;
    for (int i = 0; i < Size; ++i)
      if (!done[i] && (k < 0 || a(i, i) > a(k, k))) k = i;
    const double pivot = a(k, k);
    if (!(pivot > threshold)) break;
    done[k] = true;
    const vector column = a.col(k);
    a -= column * column.transpose() / pivot;
    a.col(k) = column / pivot;
    a.row(k) = a.col(k).transpose();
    a(k, k) = -1 / pivot;
  }
  for (int i = 0; i < Size; ++i)
    for (int j = 0; j < Size; ++j) a(i, j) = done[i] && done[j] ? -a(i, j) * scale[i] * scale[j] : 0;
  return a;
}

}  // namespace cca::detail
