// Sums over small vectors and matrices of Eigen, in one order: dot, squared_norm, norm, sum, mean, trace,
// product. Eigen's own add in the order of the machine's packets, so a dot product of three numbers has other
// bits with SSE2 than without. These have the same bits with and without packets, for any instruction set,
// unless the compiler fuses products and sums (docs/same_bits.md). The library uses no others:
// tests/scripts/reductions.py refuses them.
//
//   const double length = cca::math::norm(v);
//   const Eigen::Vector3d moved = cca::math::product(rotation, arm);   // rotation * arm
//
// The order
//   halves       of a fixed size, up to `most_terms` numbers or `most_products` products: the sum of the first
//                half (rounded down) plus the sum of the rest, each in the same way. So three are a + (b + c).
//   in sequence  from first to last, column by column (a row-major matrix: row by row), all else.
//   product()    each entry is a dot product by the rule above; where rows and products are both eight or
//                more, or a size is not fixed, it is in sequence.
// It is the order in which Eigen adds without packets, so programs built for the same bits keep theirs.
//
// Arguments: vectors, matrices and expressions of double, float, or any number with + and *. Errors: sizes
// that don't match are refused as Eigen does. An empty vector has the sum 0. NaN and infinity pass as usual.
// Cost: nothing allocates for fixed sizes; entries of a column are computed side by side, with packets where
// the machine has them.
#pragma once

#include <cca/base/eigen.hpp>
#include <cca/base/math/floats.hpp>
#include <cca/base/math/roots.hpp>

namespace cca::math {
namespace detail {

inline constexpr int most_terms = 55, most_products = 27, many = 8;

// at(First) + ... + at(First + Count - 1), in halves.
template <int First, int Count, class At>
CCA_INLINE constexpr auto in_halves(const At& at) {
  if constexpr (Count == 1) return at(First);
  else return in_halves<First, Count / 2>(at) + in_halves<First + Count / 2, Count - Count / 2>(at);
}

// Sizes as Eigen states them, as int: each of its types has an enumeration of its own.
template <class M>
inline constexpr int rows_of = M::RowsAtCompileTime;
template <class M>
inline constexpr int columns_of = M::ColsAtCompileTime;
template <class M>
inline constexpr int size_of = M::SizeAtCompileTime;
// Of two sizes that must agree, the one that is fixed.
constexpr int agreed(int a, int b) { return a != Eigen::Dynamic ? a : b; }
constexpr bool may_agree(int a, int b) { return a == b || a == Eigen::Dynamic || b == Eigen::Dynamic; }

// Entry i of a vector, or of a matrix as it lies in memory.
template <class M>
CCA_INLINE constexpr auto entry(const M& m, Eigen::Index i) {
  constexpr bool by_rows = M::IsRowMajor;
  constexpr int fixed = by_rows ? columns_of<M> : rows_of<M>;
  const Eigen::Index inner = fixed == Eigen::Dynamic ? m.innerSize() : fixed;
  return by_rows ? m.coeff(i / inner, i % inner) : m.coeff(i % inner, i / inner);
}

template <class Scalar, int Size, int Most, class At>
CCA_INLINE constexpr Scalar sum_of(Eigen::Index size, const At& at) {
  if constexpr (Size == 0) return Scalar(0);
  else if constexpr (Size != Eigen::Dynamic && Size <= Most) return in_halves<0, Size>(at);
  else {
    if (size == 0) return Scalar(0);
    Scalar result = at(0);
    for (Eigen::Index i = 1; i < size; ++i) result = result + at(i);
    return result;
  }
}

// What lies in memory stays there; an expression is computed once.
template <class M>
CCA_INLINE constexpr decltype(auto) stored(const M& m) {
  if constexpr ((M::Flags & Eigen::DirectAccessBit) != 0) return (m);
  else return typename M::PlainObject(m);
}

}  // namespace detail

template <class M>
CCA_INLINE constexpr typename M::Scalar sum(const Eigen::DenseBase<M>& m) {
  return detail::sum_of<typename M::Scalar, detail::size_of<M>, detail::most_terms>(
      m.size(), [&](Eigen::Index i) { return detail::entry(m.derived(), i); });
}

template <class A, class B>
CCA_INLINE constexpr typename A::Scalar dot(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  static_assert(A::IsVectorAtCompileTime && B::IsVectorAtCompileTime, "dot() is of two vectors");
  static_assert(detail::may_agree(detail::size_of<A>, detail::size_of<B>), "dot() is of vectors of one size");
  eigen_assert(a.size() == b.size());
  constexpr int size = detail::agreed(detail::size_of<A>, detail::size_of<B>);
  return detail::sum_of<typename A::Scalar, size, detail::most_products>(a.size(), [&](Eigen::Index i) {
    return detail::entry(a.derived(), i) * detail::entry(b.derived(), i);
  });
}

// Of a matrix: the sum of the squares of its entries.
template <class M>
CCA_INLINE constexpr typename M::Scalar squared_norm(const Eigen::MatrixBase<M>& m) {
  return detail::sum_of<typename M::Scalar, detail::size_of<M>, detail::most_products>(
      m.size(), [&](Eigen::Index i) {
        const auto x = detail::entry(m.derived(), i);
        return x * x;
      });
}

template <class M>
CCA_INLINE typename M::Scalar norm(const Eigen::MatrixBase<M>& m) {
  return sqrt(squared_norm(m));
}

template <class M>
CCA_INLINE constexpr typename M::Scalar mean(const Eigen::DenseBase<M>& m) {
  return sum(m) / static_cast<typename M::Scalar>(m.size());
}

template <class M>
CCA_INLINE constexpr typename M::Scalar trace(const Eigen::MatrixBase<M>& m) {
  return sum(m.diagonal());
}

// a * b. The product of a column and a row adds nothing and may stay Eigen's.
template <class A, class B>
CCA_INLINE auto product(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  constexpr int rows = detail::rows_of<A>, columns = detail::columns_of<B>;
  constexpr int depth = detail::agreed(detail::columns_of<A>, detail::rows_of<B>);
  static_assert(detail::may_agree(detail::columns_of<A>, detail::rows_of<B>),
                "product(): the left matrix needs as many columns as the right one has rows");
  eigen_assert(a.cols() == b.rows());
  constexpr bool by_rows = rows == 1 && columns != 1,
                 fixed = rows != Eigen::Dynamic && depth != Eigen::Dynamic;
  Eigen::Matrix<typename A::Scalar, rows, columns, by_rows ? Eigen::RowMajor : Eigen::ColMajor> result(
      a.rows(), b.cols());
  const auto& left = detail::stored(a.derived());
  const auto& right = detail::stored(b.derived());
  for (Eigen::Index j = 0; j < result.cols(); ++j) {
    if constexpr (fixed && depth <= detail::most_products && (rows < detail::many || depth < detail::many)) {
      const auto at = [&](int k) { return left.col(k) * right.coeff(k, j); };
      result.col(j) = detail::in_halves<0, depth>(at);
    } else {
      result.col(j) = left.col(0) * right.coeff(0, j);
      for (Eigen::Index k = 1; k < left.cols(); ++k) result.col(j) += left.col(k) * right.coeff(k, j);
    }
  }
  return result;
}

}  // namespace cca::math
