// How the end of a part gives way to wrenches, for recordings: M^-1 J^T and J M^-1 J^T.
//
// The numbers of mass matrix and Jacobian are inputs, so all that is known is how many there are; it saves
// the loops over a few numbers. By L D L^T, which needs no square roots. Source: Golub and Van Loan, Matrix
// Computations, 2013, section 4.1.
#pragma once

#include <array>

#include <cca/base/recording/straight_line.hpp>

namespace cca::detail {

// The mass matrix, then the rows of a Jacobian, both by columns. Gives M^-1 J^T and J M^-1 J^T by columns.
template <int Rows, int Size>
struct recorded_mobility {
  static constexpr bool is_small = Rows > 0 && Size > 0 && Size*(Size + Rows) <= most_groups;
  static constexpr std::array sizes{Size * Size, Rows* Size};
  static constexpr std::array results{Size * Rows, Rows* Rows};
  static constexpr int group(int input) { return input; }
  // All results need all inputs but the upper triangle of the mass matrix, which none needs.
  static constexpr int owner(int group) {
    return group < Size * Size && group % Size < group / Size ? 0 : -1;
  }
  static constexpr bool may_vanish(int) { return true; }  // an infinite pivot is divided by

  static constexpr void record(recorder& r) {
    const auto at = [](auto& v, int i) -> auto& { return v[static_cast<std::size_t>(i)]; };
    // The lower triangle of M becomes that of L, by rows.
    std::array<vector, static_cast<std::size_t>(Size)> l;
    vector inverse, own;
    for (int i = 0; i < Size; ++i)
      for (int k = 0; k <= i; ++k) at(at(l, i), k) = r.input(i + Size * k);
    for (int k = 0; k < Size; ++k) {
      at(inverse, k) = recorded(1.0) / at(at(l, k), k);
      for (int i = k + 1; i < Size; ++i) at(own, i) = at(at(l, i), k);
      for (int i = k + 1; i < Size; ++i) {
        vector& row = at(l, i);
        at(row, k) = at(own, i) * at(inverse, k);
        for (int j = k + 1; j <= i; ++j) at(row, j) = at(row, j) - at(row, k) * at(own, j);
      }
    }
    // Of each row of J: L^-1 row, then D^-1 times that.
    std::array<vector, static_cast<std::size_t>(Rows)> half, scaled;
    for (int row = 0; row < Rows; ++row)
      for (int i = 0; i < Size; ++i) {
        recorded x = r.input(Size * Size + row + Rows * i);
        for (int j = 0; j < i; ++j) x = x - at(at(l, i), j) * at(at(half, row), j);
        at(at(half, row), i) = x;
        at(at(scaled, row), i) = at(inverse, i) * x;
      }
    std::array<recorded, static_cast<std::size_t>(Rows * Rows)> mobility;
    for (int a = 0; a < Rows; ++a)
      for (int b = 0; b <= a; ++b) {
        recorded sum;
        for (int i = 0; i < Size; ++i) sum = sum + at(at(half, a), i) * at(at(scaled, b), i);
        at(mobility, a + Rows * b) = at(mobility, b + Rows * a) = sum;
      }
    for (vector& x : scaled) {  // L^-T times that
      for (int i = Size; i-- > 0;)
        for (int j = i + 1; j < Size; ++j) at(x, i) = at(x, i) - at(at(l, j), i) * at(x, j);
      for (const recorded& e : x) r.output(e);
    }
    for (const recorded& e : mobility) r.output(e);
  }

private:
  using vector = std::array<recorded, static_cast<std::size_t>(Size)>;
};

}  // namespace cca::detail
