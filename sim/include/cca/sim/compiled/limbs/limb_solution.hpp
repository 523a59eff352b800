// M v = f for a described robot, limb by limb: the factor L^T D L of branches.hpp, as straight code.
//
// Limbs do not meet but in the base, so each is eliminated alone, and what it takes from the base is a sum.
// Limbs of one shape share the code, several at once in the lanes of a vector. Where a force couples limbs,
// and for a limb whose rows do not all meet, loops over the rows take over. The results do not depend on how
// many limbs are computed at once.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <cca/base/compiler.hpp>
#include <cca/base/unrolled.hpp>
#include <cca/sim/compiled/limbs/in_lanes.hpp>
#include <cca/sim/compiled/limbs/limbs.hpp>

namespace cca::sim::detail {

template <class R>
struct solved_limbs {
  using tree = compiled_tree<R>;
  using all = limbs_of<R>;

  // Whether limbs meet in the base only.
  static constexpr bool are_apart = []<std::size_t... L>(std::index_sequence<L...>) {
    std::array<int, static_cast<std::size_t>(tree::size)> owner{};
    for (int& o : owner) o = -1;
    const auto own = [&](const auto& rows, std::size_t l) {
      for (const int r : rows) owner[static_cast<std::size_t>(r)] = static_cast<int>(l);
    };
    (own(limb<R, L>::row, L), ...);
    for (std::size_t k = 0; k < owner.size(); ++k)
      for (int a = tree::base; a < tree::branches.depth[k]; ++a)
        if (owner[k] != owner[static_cast<std::size_t>(tree::branches.way[k][static_cast<std::size_t>(a)])])
          return false;
    return true;
  }(std::make_index_sequence<all::count>());

  // The rows of a limb lie side by side, and each meets all before it. Beyond so many the code would be
  // large.
  template <std::size_t L>
  static constexpr bool is_straight = are_apart && limb<R, L>::is_in_one_piece && limb<R, L>::n <= 8;
  template <std::size_t L>
  static constexpr std::size_t rows = is_straight<L> ? limb<R, L>::n : 0;

  static constexpr auto rows_of = []<std::size_t... L>(std::index_sequence<L...>) {
    return std::array<std::size_t, all::count>{rows<L>...};
  }(std::make_index_sequence<all::count>());
  // The first one with as many rows.
  static constexpr auto leader = [] {
    std::array<std::size_t, all::count> first{};
    for (std::size_t l = 0; l < all::count; ++l)
      while (rows_of[first[l]] != rows_of[l]) ++first[l];
    return first;
  }();
  template <std::size_t L>
  static constexpr std::size_t size = [] {
    std::size_t n = 0;
    for (const std::size_t l : leader) n += l == L;
    return n;
  }();
  struct place {
    std::size_t limb = 0, row = 0, entry = 0;
  };
  template <std::size_t L>
  static constexpr auto places = []<std::size_t... M>(std::index_sequence<M...>) {
    std::array<place, size<L>> found{};
    std::size_t k = 0;
    const auto add = [&](std::size_t l, int row, int entry) {
      if (leader[l] == L) found[k++] = {l, static_cast<std::size_t>(row), static_cast<std::size_t>(entry)};
    };
    (add(M, limb<R, M>::row[0], limb<R, M>::places[0].entry), ...);
    return found;
  }(std::make_index_sequence<all::count>());
};

template <class R, class Real>
class limb_solution {
  using shared = solved_limbs<R>;
  using tree = compiled_tree<R>;
  using matrix = branch_matrix<tree::branches, Real>;
  using vector = typename matrix::vector;
  static constexpr auto base = static_cast<std::size_t>(tree::base), limbs = limbs_of<R>::count;
  // What a limb takes from the base: of M, its lower triangle by rows; of the vector.
  struct taken {
    std::array<Real, base*(base + 1) / 2> entries{};
    std::array<Real, base> forces{};
  };
  static constexpr std::size_t entry_of(std::size_t row, std::size_t column) {  // of a limb
    return row * base + row * (row + 1) / 2 + column;
  }

  // `Width` limbs of N rows at once, and the vector with them.
  template <std::size_t N, std::size_t Width>
  struct several {
    using number = number_of_limbs<Real, Width>;
    using place = typename shared::place;
    static constexpr std::size_t entries = entry_of(N, 0);

    [[gnu::noinline]] static void eliminate(const place* at, matrix& m, vector& v, taken* from) {
      number e[entries], x[N], inverse[N], rest[base * (base + 1) / 2 + 1]{}, forces[base + 1]{};
      cca::detail::unrolled<static_cast<int>(entries)>([&](auto k) {
        e[k()] = gathered<Real, Width>(at, [&](const place& p) { return m.entry[p.entry + k()]; });
      });
      cca::detail::unrolled<static_cast<int>(N)>([&](auto k) {
        x[k()] = gathered<Real, Width>(at, [&](const place& p) { return v[p.row + k()]; });
      });
      cca::detail::unrolled<static_cast<int>(N)>([&](auto before) {
        constexpr std::size_t i = N - 1 - static_cast<std::size_t>(before()), depth = base + i;
        number* const own = e + entry_of(i, 0);
        inverse[i] = Real(1.0) / own[depth];
        cca::detail::unrolled<static_cast<int>(depth)>([&](auto less) {
          constexpr std::size_t a = depth - 1 - static_cast<std::size_t>(less());
          const number share = own[a] * inverse[i];
          cca::detail::unrolled<static_cast<int>(a + 1)>([&](auto b) {
            constexpr auto column = static_cast<std::size_t>(b());
            if constexpr (a < base) {
              number& sum = rest[a * (a + 1) / 2 + column];
              sum = sum + share * own[column];
            } else {
              number& other = e[entry_of(a - base, column)];
              other = other - share * own[column];
            }
          });
          if constexpr (a < base) forces[a] = forces[a] + share * x[i];
          else x[a - base] = x[a - base] - share * x[i];
          own[a] = share;
        });
        x[i] = x[i] * inverse[i];
      });
      cca::detail::unrolled<static_cast<int>(entries)>([&](auto k) {
        scatter<Real, Width>(at, e[k()], [&](const place& p) -> Real& { return m.entry[p.entry + k()]; });
      });
      cca::detail::unrolled<static_cast<int>(N)>([&](auto k) {
        scatter<Real, Width>(at, inverse[k()],
                             [&](const place& p) -> Real& { return m.inverse[p.row + k()]; });
        scatter<Real, Width>(at, x[k()], [&](const place& p) -> Real& { return v[p.row + k()]; });
      });
      cca::detail::unrolled<static_cast<int>(base * (base + 1) / 2)>([&](auto k) {
        scatter<Real, Width>(at, rest[k()],
                             [&](const place& p) -> Real& { return from[p.limb].entries[k()]; });
      });
      cca::detail::unrolled<static_cast<int>(base)>([&](auto k) {
        scatter<Real, Width>(at, forces[k()],
                             [&](const place& p) -> Real& { return from[p.limb].forces[k()]; });
      });
    }
  };

  template <std::size_t L, std::size_t First, std::size_t Width>
  static void eliminate_from(matrix& m, vector& v, taken* from) {
    constexpr const auto& places = shared::template places<L>;
    constexpr std::size_t left = places.size() - First;
    if constexpr (left >= Width) {
      several<shared::template rows<L>, Width>::eliminate(places.data() + First, m, v, from);
      eliminate_from<L, First + Width, Width>(m, v, from);
    } else if constexpr (left > 0) {
      eliminate_from<L, First, 1>(m, v, from);
    }
  }

public:
  // M is factored; v becomes M^-1 v.
  static void factor_and_solve(matrix& m, vector& v) {
    constexpr auto most =
        std::is_same_v<Real, double> ? std::size_t{cca::detail::lane_count} : std::size_t{1};
    if constexpr (shared::are_apart) {
      std::array<taken, limbs> from;
      cca::detail::unrolled<static_cast<int>(limbs)>([&](auto l) {
        constexpr auto L = static_cast<std::size_t>(l());
        if constexpr (shared::template rows<L> == 0)
          for (std::size_t i = limb<R, L>::n; i-- > 0;)
            m.eliminate(static_cast<std::size_t>(limb<R, L>::row[i]), v);
        else if constexpr (shared::leader[L] == L)
          eliminate_from<L, 0, (shared::template size<L> >= most ? most : 1)>(m, v, from.data());
      });
      for (std::size_t l = 0; l < limbs; ++l) {
        if (shared::rows_of[l] == 0) continue;
        for (std::size_t k = 0; k < from[l].entries.size(); ++k) m.entry[k] = m.entry[k] - from[l].entries[k];
        for (std::size_t k = 0; k < base; ++k) v[k] = v[k] - from[l].forces[k];
      }
      cca::detail::unrolled<static_cast<int>(base)>(
          [&](auto k) { m.eliminate(base - 1 - static_cast<std::size_t>(k()), v); });
    } else {
      for (std::size_t k = v.size(); k-- > 0;) m.eliminate(k, v);
    }
    forward(m, v);
  }

  // v becomes L^-1 v.
  static void forward(const matrix& m, vector& v) {
    if constexpr (shared::are_apart) {
      cca::detail::unrolled<static_cast<int>(base)>(
          [&](auto k) { forward_row<static_cast<std::size_t>(k())>(m.entry.data(), v.data(), v.data()); });
      cca::detail::unrolled<static_cast<int>(limbs)>([&](auto l) {
        constexpr auto L = static_cast<std::size_t>(l());
        if constexpr (shared::template rows<L> == 0) {
          for (const int row : limb<R, L>::row) m.forward(static_cast<std::size_t>(row), v);
        } else if constexpr (shared::leader[L] == L) {
          for (const auto& p : shared::template places<L>)
            forward_limb<shared::template rows<L>>(m.entry.data() + p.entry, v.data(), v.data() + p.row);
        }
      });
    } else {
      for (std::size_t k = 0; k < v.size(); ++k) m.forward(k, v);
    }
  }

private:
  // Row K of the base, or row K - base of a limb: after it come the `rows` of the limb.
  template <std::size_t K>
  static void forward_row(const Real* own_entries, const Real* of_base, Real* rows) {
    const Real* const own = own_entries + (K < base ? K * (K + 1) / 2 : entry_of(K - base, 0));
    Real x = rows[K < base ? K : K - base];
    cca::detail::unrolled<static_cast<int>(K)>([&](auto a) {
      constexpr auto column = static_cast<std::size_t>(a());
      if constexpr (column < base) x = x - own[column] * of_base[column];
      else x = x - own[column] * rows[column - base];
    });
    rows[K < base ? K : K - base] = x;
  }
  template <std::size_t N>
  static void forward_limb(const Real* entries, const Real* of_base, Real* rows) {
    cca::detail::unrolled<static_cast<int>(N)>(
        [&](auto k) { forward_row<base + static_cast<std::size_t>(k())>(entries, of_base, rows); });
  }
};

}  // namespace cca::sim::detail
