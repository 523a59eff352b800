// Eigenvalues and eigenvectors of a symmetric matrix of a fixed size, without Eigen's decompositions (the
// core does not include them).
//
//   const cca::detail::symmetric_eigen<6> of(a);    a = vectors * diagonal(values) * vectors^T
//
// The values have no order. A matrix with NaN or infinity gives results that are not finite; nothing is kept.
// Cost: up to 12 sweeps, usually six, of n^2 / 2 rotations with 6 n products each; nothing allocates.
// Source: the cyclic Jacobi method, Golub and Van Loan, Matrix Computations, 2013, section 8.5.
#pragma once

#include <cmath>
#include <cstring>

#include <cca/base/eigen.hpp>
#include <cca/base/math/reductions.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/base/unrolled.hpp>

namespace cca::detail {

template <int Size>
struct symmetric_eigen {
  using matrix = Eigen::Matrix<double, Size, Size>;

  matrix vectors = matrix::Identity();
  Eigen::Matrix<double, Size, 1> values;

  explicit symmetric_eigen(matrix a) {
    for (int sweep = 0; sweep < 12; ++sweep) {
      double off = 0, all = 0;
      for (int j = 0; j < Size; ++j) {
        for (int i = 0; i < j; ++i) off += a(i, j) * a(i, j);
        all += a(j, j) * a(j, j);
      }
      if (!(off > 1e-32 * all)) break;
      for (int p = 0; p < Size; ++p)
        for (int q = p + 1; q < Size; ++q) rotate(a, p, q);
    }
    values = a.diagonal();
  }

private:
  // Makes a(p, q) zero.
  [[gnu::flatten]] void rotate(matrix& a, int p, int q) {
    if (a(p, q) == 0) return;
    const double tau = (a(q, q) - a(p, p)) / (2 * a(p, q));
    const double t = (tau < 0 ? -1 : 1) / (std::abs(tau) + math::sqrt(1 + tau * tau));
    const double c = 1 / math::sqrt(1 + t * t), s = t * c;
    turn_columns(a, p, q, c, s);
    unrolled<Size>([&](auto i) {
      const double upper = a(p, i()), lower = a(q, i());
      a(p, i()) = c * upper - s * lower;
      a(q, i()) = s * upper + c * lower;
    });
    turn_columns(vectors, p, q, c, s);
  }

  // In lanes, of two columns: docs/compilers.md says why.
  CCA_INLINE static void turn_columns(matrix& of, int p, int q, double c, double s) {
    double *const one = of.data() + p * Size, *const other = of.data() + q * Size;
    math::detail::side_by_side<0, Size>([&]<class T>(int i, T) {
      const T left = math::detail::loaded<T>(one + i), right = math::detail::loaded<T>(other + i);
      const T first = c * left - s * right, second = s * left + c * right;
      std::memcpy(one + i, &first, sizeof first);
      std::memcpy(other + i, &second, sizeof second);
    });
  }
};

}  // namespace cca::detail
