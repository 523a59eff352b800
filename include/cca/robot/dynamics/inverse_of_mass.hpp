// The inverse of a mass matrix and its product with others, for the derivatives of accelerations.
//
// By Gauss and Jordan on the columns, in the lanes of vectors; a positive definite matrix needs no other
// pivots. What is zero in every pose, between limbs that do not move one another, costs nothing and stays
// zero: so a number that is NaN or infinite stays in the columns of its limb.
// Cost: n^3 products for the inverse if all coordinates move one another; nothing allocates.
#pragma once

#include <cstring>

#include <cca/base/compiler.hpp>
#include <cca/base/inlining.hpp>
#include <cca/base/unrolled.hpp>
#include <cca/robot/body_pose.hpp>

namespace cca::detail {

template <int Rows, int Columns = Rows>
struct coordinate_pairs {
  bool all[std::size_t{Rows * Columns + 1}]{};
  constexpr bool& operator()(int r, int c) { return all[r * Columns + c]; }
  constexpr bool operator()(int r, int c) const { return all[r * Columns + c]; }
  constexpr bool are_all() const {
    for (int k = 0; k < Rows * Columns; ++k)
      if (!all[k]) return false;
    return true;
  }
};

// Coordinates of which one is before the other on a branch: M is zero elsewhere.
template <int Size, std::size_t Count>
constexpr coordinate_pairs<Size> branch_pairs(const std::array<body_link, Count>& links) {
  coordinate_pairs<Size> of;
  for (const body_link& l : links)
    for (int j = static_cast<int>(&l - links.data()); j >= 0; j = links[static_cast<std::size_t>(j)].parent) {
      const int other = links[static_cast<std::size_t>(j)].coordinate;
      of(l.coordinate, other) = of(other, l.coordinate) = true;
    }
  return of;
}

// Which coordinates move one another: the inverse of M is zero elsewhere.
template <int Size>
constexpr coordinate_pairs<Size> coupled(coordinate_pairs<Size> of) {
  for (int k = 0; k < Size; ++k)
    for (int i = 0; i < Size; ++i)
      for (int j = 0; j < Size; ++j) of(i, j) = of(i, j) || (of(i, k) && of(k, j));
  return of;
}

template <class Body>
inline constexpr auto branches_of = branch_pairs<axes_of<Body>::count>(weighed_links_of<Body>);
template <class Body>
inline constexpr auto coupled_coordinates_of = coupled(branches_of<Body>);

// The coordinates of a body whose base moves as it is told.
template <class Body>
struct held_coordinates {
  static constexpr int size = axes_of<Body>::count;
  static constexpr auto mass = branches_of<Body>, inverse = coupled_coordinates_of<Body>;
};
// With the motion of a free base as the first six.
template <class Body>
struct free_coordinates {
  static constexpr int n = axes_of<Body>::count, size = 6 + n;
  static constexpr auto mass = [] {
    coordinate_pairs<size> of;
    for (int r = 0; r < size; ++r)
      for (int c = 0; c < size; ++c) of(r, c) = r < 6 || c < 6 || branches_of<Body>(r - 6, c - 6);
    return of;
  }();
  static constexpr auto inverse = coupled(mass);
  static constexpr auto by_coordinates = [] {  // the columns of `mass` without those of the base
    coordinate_pairs<size, n> of;
    for (int r = 0; r < size; ++r)
      for (int c = 0; c < n; ++c) of(r, c) = mass(r, 6 + c);
    return of;
  }();
  static constexpr auto by_base = [] {
    coordinate_pairs<size, 3> of;
    for (bool& all : of.all) all = true;
    return of;
  }();
};

template <class Coordinates>
class inverse_of_mass {
  static constexpr int size = Coordinates::size, width = (size + lane_count - 1) / lane_count;
  static constexpr const auto& reached = Coordinates::inverse;
  using matrix = Eigen::Matrix<double, size, size>;
  struct column {
    lanes e[std::size_t{width + 1}]{};

    double at(int r) const { return e[r / lane_count][r % lane_count]; }
    void set(int r, double x) { e[r / lane_count][r % lane_count] = x; }
    CCA_INLINE void add(double factor, const column& c) {
      unrolled<width>([&](auto w) { e[w()] += factor * c.e[w()]; });
    }
    template <class Matrix>
    CCA_INLINE void write(Matrix& to, int c) const {
      std::memcpy(to.data() + c * size, e, size * sizeof(double));
    }
  };
  column columns[std::size_t{size + 1}];

  template <class Matrix>
  CCA_INLINE static void clear_unreached(Matrix& m) {
    if constexpr (!reached.are_all()) {
      static_assert(Matrix::ColsAtCompileTime == size);
      for (int c = 0; c < size; ++c)
        for (int r = 0; r < size; ++r)
          if (!reached(r, c)) m(r, c) = 0;
    }
  }
  // The columns that step k changes. The steps go from the last coordinate to the first: between limbs, zeros
  // stay zeros until the base.
  static constexpr auto changed = [] {
    coordinate_pairs<size> changes, filled = Coordinates::mass;
    for (int k = size; k-- > 0;)
      for (int j = 0; j < size; ++j) {
        if (j == k || !filled(k, j)) continue;
        changes(k, j) = true;
        for (int r = 0; r < size; ++r) filled(r, j) = filled(r, j) || filled(r, k);
      }
    return changes;
  }();

public:
  explicit inverse_of_mass(const matrix& m) {
    for (int k = 0; k < size; ++k) std::memcpy(columns[k].e, m.data() + k * size, size * sizeof(double));
    for (int k = size; k-- > 0;) {
      const column own = columns[k];
      const double inverse = 1 / own.at(k);
      for (int j = 0; j < size; ++j) {
        if (!changed(k, j)) continue;
        const double factor = columns[j].at(k) * inverse;
        columns[j].add(-factor, own);
        columns[j].set(k, factor);
      }
      columns[k] = {};
      columns[k].add(-inverse, own);
      columns[k].set(k, inverse);
    }
  }
  void write(matrix& to) const {
    for (int k = 0; k < size; ++k) columns[k].write(to, k);
    clear_unreached(to);
  }
  // - m^-1 b, where b is zero in every pose but in the entries that `pairs` has.
  template <const auto& Pairs, int Columns>
  void write_minus_product(const Eigen::Matrix<double, size, Columns>& b,
                           Eigen::Matrix<double, size, Columns>& to) const {
    constexpr bool always = Pairs.are_all();
    for (int c = 0; c < Columns; ++c) {
      column sum;
      for (int k = 0; k < size; ++k)
        if (always || Pairs(k, c)) sum.add(-b(k, c), columns[k]);
      sum.write(to, c);
    }
    clear_unreached(to);
  }
};

}  // namespace cca::detail
