// Symmetric positive matrices over the coordinates of a tree, with their zeros known at compile time.
//
// The rows are the motion of a base that floats (angular velocity, velocity), then the coordinates, each
// after those before it on its branch. Row k has an entry for each row before it on its branch and for
// itself; the others are zero, and stay zero in the factor L^T D L. What is before a row is also before each
// row behind it, so the entries of two rows that meet lie side by side in the same order.
// Coordinates of different limbs that one force couples (a cable from leg to leg) become one branch.
// Sources: Featherstone, Rigid Body Dynamics Algorithms, 2008, section 6.5 and 8.4; the elimination tree:
// Liu, The Role of Elimination Trees in Sparse Factorization, 1990.
#pragma once

#include <array>
#include <cstddef>

#include <cca/robot/recorded/composite_bodies.hpp>

namespace cca::sim::detail {

// A variable is a number of the base's motion (0 to 5) or 6 plus a coordinate; of a base that is held, a
// coordinate.
template <int Size>
struct branches {
  static constexpr auto n = static_cast<std::size_t>(Size);

  std::array<int, n> row{};                 // of each variable
  std::array<int, n> variable{};            // of each row
  std::array<int, n> depth{};               // of each row: how many are before it on its branch
  std::array<int, n> first{};               // of each row: the first of its entries
  std::array<std::array<int, n>, n> way{};  // of each row: those before it on its branch, and itself
  int entries = 0;

  static constexpr int size = Size;
};

// `couples(c, d)`: whether one force moves the coordinates c and d, beside those of one branch.
template <bool Floats, int Size, std::size_t Count, class Couples>
constexpr branches<Size> branches_of(const cca::detail::reduced_body<Count>& body, Couples couples) {
  constexpr int base = Floats ? 6 : 0;
  constexpr auto n = static_cast<std::size_t>(Size);
  branches<Size> b;
  b.variable = cca::detail::order_of_solution<Floats, Size>(body);
  for (std::size_t k = 0; k < n; ++k) b.row[static_cast<std::size_t>(b.variable[k])] = static_cast<int>(k);

  std::array<std::array<bool, n>, n> meet{};  // row, a row before it
  const auto join = [&](int i, int j) {
    const int at = base + i, other = base + j;
    const int r = b.row[static_cast<std::size_t>(at)], s = b.row[static_cast<std::size_t>(other)];
    meet[static_cast<std::size_t>(r > s ? r : s)][static_cast<std::size_t>(r > s ? s : r)] = true;
  };
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < k && j < base; ++j) meet[k][j] = true;
  for (const auto& l : body.links)
    for (int j = l.parent; j >= 0; j = body.links[static_cast<std::size_t>(j)].parent)
      join(l.coordinate, body.links[static_cast<std::size_t>(j)].coordinate);
  for (int c = 0; c < Size - base; ++c)
    for (int d = 0; d < c; ++d)
      if (couples(c, d)) join(c, d);

  std::array<int, n> before{};
  for (std::size_t k = n; k-- > 0;) {
    before[k] = -1;
    for (std::size_t j = 0; j < k; ++j)
      if (meet[k][j]) before[k] = static_cast<int>(j);
    for (std::size_t j = 0; before[k] > static_cast<int>(j); ++j)
      if (meet[k][j]) meet[static_cast<std::size_t>(before[k])][j] = true;
  }
  for (std::size_t k = 0; k < n; ++k) {
    if (before[k] >= 0) {
      const auto p = static_cast<std::size_t>(before[k]);
      b.way[k] = b.way[p], b.depth[k] = b.depth[p] + 1;
    }
    b.way[k][static_cast<std::size_t>(b.depth[k])] = static_cast<int>(k);
    b.first[k] = b.entries;
    b.entries += b.depth[k] + 1;
  }
  return b;
}

template <const auto& Of, class Real>
struct branch_matrix {
  static constexpr auto size = static_cast<std::size_t>(Of.size);
  using vector = std::array<Real, size>;

  // As they are left: `branch_matrix<...> m{}` is zero.
  std::array<Real, static_cast<std::size_t>(Of.entries)> entry;
  vector inverse;  // of D, once it is factored

  // The entries of a row; the last one is on the diagonal.
  constexpr Real* row(std::size_t k) { return entry.data() + Of.first[k]; }
  constexpr const Real* row(std::size_t k) const { return entry.data() + Of.first[k]; }
  constexpr Real& diagonal(std::size_t k) { return row(k)[Of.depth[k]]; }

  // v^T M v.
  constexpr Real form(const vector& v) const {
    Real sum{};
    for (std::size_t k = 0; k < size; ++k) {
      const Real* const own = row(k);
      const auto depth = static_cast<std::size_t>(Of.depth[k]);
      Real product = own[depth] * v[k];
      for (std::size_t a = 0; a < depth; ++a)
        product = product + Real(2.0) * own[a] * v[static_cast<std::size_t>(Of.way[k][a])];
      sum = sum + v[k] * product;
    }
    return sum;
  }

  // L^T D L, and v with it: each row from the last to the first. L is left beside the diagonal.
  constexpr void eliminate(std::size_t k, vector& v) {
    Real* const own = row(k);
    const auto depth = static_cast<std::size_t>(Of.depth[k]);
    inverse[k] = Real(1.0) / own[depth];
    for (std::size_t a = depth; a-- > 0;) {
      const auto at = static_cast<std::size_t>(Of.way[k][a]);
      Real* const other = row(at);
      const Real x = own[a] * inverse[k];
      for (std::size_t b = 0; b <= a; ++b) other[b] = other[b] - x * own[b];
      v[at] = v[at] - x * v[k];
      own[a] = x;
    }
    v[k] = v[k] * inverse[k];
  }
  // Then v becomes L^-1 v: each row from the first to the last.
  constexpr void forward(std::size_t k, vector& v) const {
    const Real* const own = row(k);
    for (std::size_t a = 0; a < static_cast<std::size_t>(Of.depth[k]); ++a)
      v[k] = v[k] - own[a] * v[static_cast<std::size_t>(Of.way[k][a])];
  }
};

}  // namespace cca::sim::detail
