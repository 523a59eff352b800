// The limbs of a described robot: what hangs on its base by one joint, or by several that share a coordinate.
//
// Between limbs M has zeros, and what a limb does to the base is a sum; so each limb is computed alone, as a
// reduced body of its own (`limb`). Legs are often equal but for the numbers and the signs of some
// coordinates: `model` is the limb of which a limb is such a copy, and `sign` the sign of each coordinate.
#pragma once

#include <array>
#include <cstddef>

#include <cca/sim/compiled/compiled_tree.hpp>

namespace cca::sim::detail {

template <class R>
class limbs_of {
  using tree = compiled_tree<R>;
  static constexpr const auto& body = tree::reduced;
  using link_numbers = std::array<int, tree::links>;
  static constexpr const auto& link(int i) { return body.links[static_cast<std::size_t>(i)]; }
  static constexpr int number_of_links = static_cast<int>(tree::links);

public:
  static constexpr link_numbers of_link = [] {
    link_numbers limb{};
    for (int i = 0; i < number_of_links; ++i) {
      const int parent = link(i).parent;
      limb[static_cast<std::size_t>(i)] = parent < 0 ? i : limb[static_cast<std::size_t>(parent)];
    }
    for (bool joined = true; joined;) {
      joined = false;
      for (int i = 0; i < number_of_links; ++i)
        for (int j = 0; j < i; ++j) {
          const int a = limb[static_cast<std::size_t>(i)], b = limb[static_cast<std::size_t>(j)];
          if (a == b || link(i).coordinate != link(j).coordinate) continue;
          for (int& x : limb)
            if (x == (a > b ? a : b)) x = a > b ? b : a;
          joined = true;
        }
    }
    link_numbers number{};
    int count = 0;
    for (int i = 0; i < number_of_links; ++i) {
      const auto k = static_cast<std::size_t>(i);
      number[k] = limb[k] == i ? count++ : number[static_cast<std::size_t>(limb[k])];
    }
    return number;
  }();
  static constexpr std::size_t count = [] {
    int n = 0;
    for (const int l : of_link) n = l >= n ? l + 1 : n;
    return static_cast<std::size_t>(n);
  }();

  // The links of a limb, ascending.
  struct list {
    link_numbers at{};
    int count = 0;
    constexpr void add(int x) { at[static_cast<std::size_t>(count++)] = x; }
    constexpr int operator[](int k) const { return at[static_cast<std::size_t>(k)]; }
    constexpr int index_of(int x) const {
      int k = 0;
      while (k < count && (*this)[k] != x) ++k;
      return k < count ? k : -1;
    }
  };
  static constexpr auto links = [] {
    std::array<list, count> all{};
    for (int i = 0; i < number_of_links; ++i)
      all[static_cast<std::size_t>(of_link[static_cast<std::size_t>(i)])].add(i);
    return all;
  }();

private:
  static constexpr bool same_zeros(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    for (std::size_t k = 0; k < 3; ++k)
      if ((a[k] == 0) != (b[k] == 0)) return false;
    return true;
  }
  static constexpr bool is_like(const list& a, const list& b) {
    if (a.count != b.count) return false;
    for (int k = 0; k < a.count; ++k) {
      const auto &x = link(a[k]), &y = link(b[k]);
      const double sum = x.ratio + y.ratio, difference = x.ratio - y.ratio;
      if (a.index_of(x.parent) != b.index_of(y.parent) || x.revolute != y.revolute || x.axis != y.axis ||
          x.straight != y.straight || (sum != 0 && difference != 0) || !same_zeros(x.at, y.at) ||
          !same_zeros(x.mass.first, y.mass.first))
        return false;
    }
    return true;
  }

public:
  static constexpr auto model = [] {
    std::array<std::size_t, count> of{};
    for (std::size_t l = 0; l < count; ++l) {
      of[l] = 0;
      while (of[l] < l && !is_like(links[of[l]], links[l])) ++of[l];
    }
    return of;
  }();

  // Of each coordinate, by the first link that it moves.
  static constexpr auto sign = [] {
    std::array<double, static_cast<std::size_t>(tree::coordinates)> of{};
    for (std::size_t l = 0; l < count; ++l)
      for (int k = 0; k < links[l].count; ++k) {
        const auto& own = link(links[l][k]);
        double& s = of[static_cast<std::size_t>(own.coordinate)];
        if (s == 0) s = own.ratio == link(links[model[l]][k]).ratio ? 1 : -1;
      }
    return of;
  }();
};

// A limb as a reduced body. Its coordinates are numbered in the order of their rows, and have the signs of
// its model.
template <class R, std::size_t L>
struct limb {
  using tree = compiled_tree<R>;
  using all = limbs_of<R>;
  static constexpr const auto& given = all::links[L];
  static constexpr auto links = static_cast<std::size_t>(given.count);

  // Ascending: the rows that the links have; the joint values.
  static constexpr std::size_t count_where(const auto& is_used) {
    std::size_t sum = 0;
    for (const bool used : is_used) sum += used;
    return sum;
  }
  static constexpr auto is_row = [] {
    std::array<bool, static_cast<std::size_t>(tree::size)> used{};
    for (int k = 0; k < given.count; ++k) {
      const int c = tree::base + tree::reduced.links[static_cast<std::size_t>(given[k])].coordinate;
      used[static_cast<std::size_t>(tree::branches.row[static_cast<std::size_t>(c)])] = true;
    }
    return used;
  }();
  static constexpr auto is_value = [] {
    std::array<bool, tree::links> used{};
    for (int k = 0; k < given.count; ++k)
      used[static_cast<std::size_t>(tree::reduced.links[static_cast<std::size_t>(given[k])].value)] = true;
    return used;
  }();
  static constexpr std::size_t n = count_where(is_row), values = count_where(is_value);
  template <std::size_t Count>
  static constexpr std::array<int, Count> where(const auto& is_used) {
    std::array<int, Count> numbers{};
    for (std::size_t i = 0, k = 0; i < is_used.size(); ++i)
      if (is_used[i]) numbers[k++] = static_cast<int>(i);
    return numbers;
  }
  static constexpr auto row = where<n>(is_row);
  static constexpr auto value = where<values>(is_value);
  static constexpr auto link = [] {
    std::array<int, links> numbers{};
    for (int k = 0; k < given.count; ++k) numbers[static_cast<std::size_t>(k)] = given[k];
    return numbers;
  }();

  static constexpr int index_in(const auto& numbers, int x) {
    for (std::size_t k = 0; k < numbers.size(); ++k)
      if (numbers[k] == x) return static_cast<int>(k);
    return -1;
  }
  static constexpr auto body = [] {
    cca::detail::reduced_body<links> b;
    for (std::size_t k = 0; k < links; ++k) {
      auto& l = b.links[k];
      l = tree::reduced.links[static_cast<std::size_t>(link[k])];
      l.ratio *= all::sign[static_cast<std::size_t>(l.coordinate)];
      l.back = l.revolute && l.ratio < 0;
      l.parent = given.index_of(l.parent);
      const int variable = tree::base + l.coordinate;
      l.coordinate = index_in(row, tree::branches.row[static_cast<std::size_t>(variable)]);
      l.value = index_in(value, l.value);
    }
    b.value_count = static_cast<int>(values);
    return b;
  }();

  // Of the entries of its rows in M, those that it has: the base's, then its own.
  static constexpr std::size_t entries = [] {
    std::size_t count = 0;
    for (std::size_t i = 0; i < n; ++i) count += static_cast<std::size_t>(tree::base) + i + 1;
    return count;
  }();
  struct place_in_mass {
    int entry = -1;           // in branch_matrix; -1: the rows do not meet
    int row = 0, column = 0;  // of the limb: the base's, then its own
  };
  static constexpr auto places = [] {
    std::array<place_in_mass, entries> all{};
    std::size_t at = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto& way = tree::branches.way[static_cast<std::size_t>(row[i])];
      const int depth = tree::branches.depth[static_cast<std::size_t>(row[i])];
      for (int c = 0; c < tree::base + static_cast<int>(i) + 1; ++c, ++at) {
        const int other = c < tree::base ? c : row[static_cast<std::size_t>(c - tree::base)];
        all[at].row = tree::base + static_cast<int>(i), all[at].column = c;
        for (int a = 0; a <= depth; ++a)
          if (way[static_cast<std::size_t>(a)] == other)
            all[at].entry = tree::branches.first[static_cast<std::size_t>(row[i])] + a;
      }
    }
    return all;
  }();
  static constexpr double sign_of(int own_row) {  // of the limb
    if (own_row < tree::base) return 1;
    const int variable =
        tree::branches
            .variable[static_cast<std::size_t>(row[static_cast<std::size_t>(own_row - tree::base)])];
    return all::sign[static_cast<std::size_t>(variable - tree::base)];
  }

  // All its numbers lie side by side, so code that is shared needs only the first of each.
  static constexpr bool is_in_one_piece = [] {
    for (std::size_t k = 1; k < links; ++k)
      if (link[k] != link[0] + static_cast<int>(k)) return false;
    for (std::size_t k = 1; k < n; ++k)
      if (row[k] != row[0] + static_cast<int>(k)) return false;
    for (std::size_t k = 1; k < values; ++k)
      if (value[k] != value[0] + static_cast<int>(k)) return false;
    for (std::size_t k = 0; k < entries; ++k)
      if (places[k].entry != places[0].entry + static_cast<int>(k)) return false;
    return true;
  }();
};

}  // namespace cca::sim::detail
