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

#include <cstring>
#include <type_traits>

#include <cca/base/eigen.hpp>
#include <cca/base/math/floats.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/base/unrolled.hpp>

namespace cca::math {
namespace detail {

inline constexpr int most_terms = 55, most_products = 27, many = 8;

// at(First) + ... + at(First + Count - 1), in halves.
template <int First, int Count, class At>
CCA_INLINE constexpr auto in_halves(const At& at) {
  if constexpr (Count == 1) return at(First);
  else return in_halves<First, Count / 2>(at) + in_halves<First + Count / 2, Count - Count / 2>(at);
}

// The same of a(k) * b(k). A product stands in one expression with its sum: docs/compilers.md says why.
template <int First, int Count, class A, class B>
CCA_INLINE constexpr auto products_in_halves(const A& a, const B& b) {
  constexpr int half = Count / 2;
  if constexpr (Count == 1) return a(First) * b(First);
  else if constexpr (Count == 2) return a(First) * b(First) + a(First + 1) * b(First + 1);
  else if constexpr (half == 1) return a(First) * b(First) + products_in_halves<First + 1, Count - 1>(a, b);
  else return products_in_halves<First, half>(a, b) + products_in_halves<First + half, Count - half>(a, b);
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
  if constexpr (columns_of<M> == 1) return m.coeff(i, 0);
  else if constexpr (rows_of<M> == 1) return m.coeff(0, i);
  else {
    constexpr int fixed = M::IsRowMajor ? columns_of<M> : rows_of<M>;
    const Eigen::Index inner = fixed == Eigen::Dynamic ? m.innerSize() : fixed;
    return M::IsRowMajor ? m.coeff(i / inner, i % inner) : m.coeff(i % inner, i / inner);
  }
}

template <class Scalar, int Size, class At>
CCA_INLINE constexpr Scalar sum_of(Eigen::Index size, const At& at) {
  if constexpr (Size == 0) return Scalar(0);
  else if constexpr (Size != Eigen::Dynamic && Size <= most_terms) return in_halves<0, Size>(at);
  else {
    if (size == 0) return Scalar(0);
    Scalar result = at(0);
    for (Eigen::Index i = 1; i < size; ++i) result = result + at(i);
    return result;
  }
}
// Of products; Scalar: also a number of lanes.
template <class Scalar, int Size, bool Halves, class A, class B>
CCA_INLINE constexpr Scalar sum_of_products(Eigen::Index size, const A& a, const B& b) {
  if constexpr (Size == 0) return Scalar{};
  else if constexpr (Halves) return products_in_halves<0, Size>(a, b);
  else {
    if (size == 0) return Scalar{};
    Scalar result = a(0) * b(0);
    for (Eigen::Index k = 1; k < size; ++k) result = result + a(k) * b(k);
    return result;
  }
}
constexpr bool are_few(int products) { return products != Eigen::Dynamic && products <= most_products; }
template <int Rows, int Depth>
inline constexpr bool in_halves_too =
    Rows != Eigen::Dynamic && are_few(Depth) && (Rows < many || Depth < many);

// What lies in memory stays there; an expression is computed once.
template <class M>
CCA_INLINE constexpr decltype(auto) stored(const M& m) {
  if constexpr ((M::Flags & Eigen::DirectAccessBit) != 0) return (m);
  else return typename M::PlainObject(m);
}

// Doubles of which each column lies in memory without gaps.
template <class M>
inline constexpr bool has_whole_columns =
    std::is_same_v<typename M::Scalar, double> && !M::IsRowMajor && rows_of<M> != 1 &&
    (M::Flags & Eigen::DirectAccessBit) != 0 && M::InnerStrideAtCompileTime == 1;

template <class T>
CCA_INLINE T loaded(const double* from) {
  T x;
  std::memcpy(&x, from, sizeof x);
  return x;
}

// Calls f(first, T{}) for the entries of a column: T is as many of them as are computed at once.
template <int First, int Size, class F>
CCA_INLINE void side_by_side(const F& f) {
  using namespace cca::detail;
  constexpr int left = Size - First;
  if constexpr (left > 0 && left % lane_count == 0) {
    f(First, lanes{});
    side_by_side<First + lane_count, Size>(f);
  } else if constexpr (left >= 2) {
    f(First, typename some_lanes<2>::vector{});
    side_by_side<First + 2, Size>(f);
  } else if constexpr (left == 1) f(First, double{});
}

// Column j of a product.
template <int Depth, class A, class B, class Result>
CCA_INLINE void write_column(const A& left, const B& right, Eigen::Index j, Result& result) {
  using scalar = typename Result::Scalar;
  constexpr int rows = rows_of<Result>;
  constexpr bool few_rows = rows != Eigen::Dynamic && rows < many, halves = in_halves_too<rows, Depth>;
  const auto of_right = [&](Eigen::Index k) { return right.coeff(k, j); };
  if constexpr (few_rows && has_whole_columns<A>) {
    side_by_side<0, rows>([&]<class T>(Eigen::Index i, T) {
      const T some = sum_of_products<T, Depth, halves>(
          left.cols(), [&](Eigen::Index k) { return loaded<T>(left.data() + i + k * left.outerStride()); },
          of_right);
      std::memcpy(result.data() + i + j * result.outerStride(), &some, sizeof some);
    });
  } else if constexpr (few_rows) {
    cca::detail::unrolled<rows>([&](auto i) {
      result.coeffRef(i(), j) = sum_of_products<scalar, Depth, halves>(
          left.cols(), [&](Eigen::Index k) { return left.coeff(i(), k); }, of_right);
    });
  } else if constexpr (halves) {
    result.col(j) = in_halves<0, Depth>([&](int k) { return left.col(k) * right.coeff(k, j); });
  } else {
    result.col(j) = left.col(0) * right.coeff(0, j);
    for (Eigen::Index k = 1; k < left.cols(); ++k) result.col(j) += left.col(k) * right.coeff(k, j);
  }
}

// All columns, written out.
template <int Depth, class A, class B, class Result>
CCA_INLINE void write_columns(const A& left, const B& right, Result& result) {
  cca::detail::unrolled<columns_of<Result>>([&](auto j) { write_column<Depth>(left, right, j(), result); });
}
// The same of a larger product, with all calls inlined: docs/compilers.md says why.
template <int Depth, class A, class B, class Result>
[[gnu::flatten]] CCA_INLINE void write_many_columns(const A& left, const B& right, Result& result) {
  write_columns<Depth>(left, right, result);
}

}  // namespace detail

template <class M>
CCA_INLINE constexpr typename M::Scalar sum(const Eigen::DenseBase<M>& m) {
  return detail::sum_of<typename M::Scalar, detail::size_of<M>>(
      m.size(), [&](Eigen::Index i) { return detail::entry(m.derived(), i); });
}

template <class A, class B>
CCA_INLINE constexpr typename A::Scalar dot(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b) {
  static_assert(A::IsVectorAtCompileTime && B::IsVectorAtCompileTime, "dot() is of two vectors");
  static_assert(detail::may_agree(detail::size_of<A>, detail::size_of<B>), "dot() is of vectors of one size");
  eigen_assert(a.size() == b.size());
  constexpr int size = detail::agreed(detail::size_of<A>, detail::size_of<B>);
  return detail::sum_of_products<typename A::Scalar, size, detail::are_few(size)>(
      a.size(), [&](Eigen::Index i) { return detail::entry(a.derived(), i); },
      [&](Eigen::Index i) { return detail::entry(b.derived(), i); });
}

// Of a matrix: the sum of the squares of its entries.
template <class M>
CCA_INLINE constexpr typename M::Scalar squared_norm(const Eigen::MatrixBase<M>& m) {
  constexpr int size = detail::size_of<M>;
  const auto at = [&](Eigen::Index i) { return detail::entry(m.derived(), i); };
  return detail::sum_of_products<typename M::Scalar, size, detail::are_few(size)>(m.size(), at, at);
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
  constexpr bool by_rows = rows == 1 && columns != 1;
  Eigen::Matrix<typename A::Scalar, rows, columns, by_rows ? Eigen::RowMajor : Eigen::ColMajor> result(
      a.rows(), b.cols());
  const auto& left = detail::stored(a.derived());
  const auto& right = detail::stored(b.derived());
  if constexpr (rows > 0 && rows < detail::many && columns > 1 && columns < detail::many &&
                detail::in_halves_too<rows, depth>) {
    if constexpr (rows * columns * depth > detail::most_products)
      detail::write_many_columns<depth>(left, right, result);
    else detail::write_columns<depth>(left, right, result);
  } else {
    for (Eigen::Index j = 0; j < result.cols(); ++j) detail::write_column<depth>(left, right, j, result);
  }
  return result;
}

}  // namespace cca::math
