// The dynamics of all limbs in one posture, as straight code.
//
// Each limb is a recording (limb_dynamics.hpp) without loops and without zeros. Limbs whose recordings have
// the same operations share their code; then it takes several at once, in the lanes of a vector, and their
// numbers come from a table. A limb that is too large for a recording is computed in loops over its links.
// The results do not depend on how many are computed at once.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <cca/base/compiler.hpp>
#include <cca/base/recording/straight_line.hpp>
#include <cca/base/unrolled.hpp>
#include <cca/sim/compiled/limbs/in_lanes.hpp>
#include <cca/sim/compiled/limbs/limb_dynamics.hpp>

namespace cca::sim::detail {

// Where the limbs write.
template <class R, class Real>
struct posture_of_limbs {
  using tree = compiled_tree<R>;
  std::array<placed_frame<Real>, tree::links>& frames;
  branch_matrix<tree::branches, Real>& mass;
  typename branch_matrix<tree::branches, Real>::vector& forces;
  std::array<load_of_limb<Real>, limbs_of<R>::count>& at_base;
};

// What they read: of the joint values, the cosines and the sines; speeds over the rows. All have the signs of
// the limbs' models.
template <class R, class Real>
struct motion_of_limbs {
  static constexpr auto values = static_cast<std::size_t>(compiled_tree<R>::reduced.value_count);
  std::array<Real, 2 * values> values_of_joints{};
  std::array<Real, static_cast<std::size_t>(compiled_tree<R>::size)> speeds{};
  triple<Real> turning{}, up{};

  template <class Limb>
  constexpr auto values_of() const {
    std::array<Real, 2 * Limb::values> of{};
    for (std::size_t k = 0; k < Limb::values; ++k) {
      const auto at = static_cast<std::size_t>(Limb::value[k]);
      of[k] = values_of_joints[at], of[Limb::values + k] = values_of_joints[values + at];
    }
    return of;
  }
};

template <class R>
struct shared_limbs {
  using all = limbs_of<R>;
  template <std::size_t L>
  using recording = recorded_limb<limb<R, L>>;

  template <std::size_t L>
  static constexpr bool is_recorded = cca::detail::is_recorded<recording<L>>();

  template <std::size_t L, std::size_t Model>
  static constexpr bool has_code_of = [] {
    if constexpr (L == Model) {
      return true;
    } else if constexpr (!limb<R, L>::is_in_one_piece || !limb<R, Model>::is_in_one_piece ||
                         !is_recorded<L> || !is_recorded<Model>) {
      return false;
    } else {
      constexpr const auto &a = cca::detail::tape_of<recording<L>>,
                           &b = cca::detail::tape_of<recording<Model>>;
      return a.inputs == b.inputs && a.constants == b.constants && a.operations == b.operations &&
             a.operation == b.operation && a.output == b.output;
    }
  }();
  static constexpr auto leader = []<std::size_t... L>(std::index_sequence<L...>) {
    return std::array<std::size_t, sizeof...(L)>{(has_code_of<L, all::model[L]> ? all::model[L] : L)...};
  }(std::make_index_sequence<all::count>());

  template <std::size_t L>
  static constexpr std::size_t size = [] {
    std::size_t n = 0;
    for (const std::size_t l : leader) n += l == L;
    return n;
  }();
  template <std::size_t L>
  static constexpr auto members = [] {
    std::array<std::size_t, size<L>> found{};
    for (std::size_t l = 0, k = 0; l < all::count; ++l)
      if (leader[l] == L) found[k++] = l;
    return found;
  }();
};

// Of the limbs that have the code of limb L: `Width` of them at once.
template <class R, class Real, std::size_t L, std::size_t Width>
class limb_code {
  using shared = shared_limbs<R>;
  using own = limb<R, L>;
  using tree = compiled_tree<R>;
  using number = number_of_limbs<Real, Width>;
  using tape = recorded_limb<own>;
  static constexpr const auto& t = cca::detail::tape_of<tape>;
  static constexpr int rows = t.inputs + t.constants + t.operations;
  static constexpr auto constants = static_cast<std::size_t>(t.constants), n = own::n;

  // Of one limb: the first of its numbers, and the constants of its tape, then the signs of its coordinates.
  struct member {
    std::size_t limb = 0, link = 0, row = 0, value = 0, entry = 0;
    std::array<double, constants + n> numbers{};
  };
  template <std::size_t M>
  static constexpr member member_of = [] {
    using of = limb<R, M>;
    member m;
    m.limb = M, m.link = static_cast<std::size_t>(of::link[0]), m.row = static_cast<std::size_t>(of::row[0]);
    m.value = static_cast<std::size_t>(of::value[0]);
    m.entry = static_cast<std::size_t>(of::places[0].entry);
    for (std::size_t k = 0; k < constants; ++k)
      m.numbers[k] = cca::detail::tape_of<recorded_limb<of>>.constant[k];
    for (std::size_t i = 0; i < n; ++i)
      m.numbers[constants + i] = of::sign_of(tree::base + static_cast<int>(i));
    return m;
  }();
  // Some limbs at once; their constants and signs lie side by side.
  struct some {
    std::array<member, Width> of{};
    alignas(number) std::array<double, Width*(constants + n)> numbers{};
  };
  template <std::size_t First>
  static constexpr some some_of = []<std::size_t... I>(std::index_sequence<I...>) {
    some s;
    s.of = {member_of<shared::template members<L>[First + I]>...};
    for (std::size_t k = 0; k < constants + n; ++k)
      for (std::size_t l = 0; l < Width; ++l) s.numbers[Width * k + l] = s.of[l].numbers[k];
    return s;
  }(std::make_index_sequence<Width>());
  static constexpr auto turns = []<std::size_t... I>(std::index_sequence<I...>) {
    std::array<bool, n> any{};
    for (std::size_t i = 0; i < n; ++i)
      any[i] = ((member_of<shared::template members<L>[I]>.numbers[constants + i] < 0) || ...);
    return any;
  }(std::make_index_sequence<shared::template size<L>>());

  template <std::size_t K>
  [[gnu::always_inline]] static number constant(const some& s) {
    if constexpr (Width == 1) {
      return number(s.numbers[K]);
    } else {
      number x{};
      for (std::size_t l = 0; l < Width; ++l) x[l] = s.numbers[Width * K + l];
      return x;
    }
  }
  using motion = motion_of_limbs<R, Real>;
  template <std::size_t I>
  [[gnu::always_inline]] static number input(const motion& m, const some& s) {
    constexpr std::size_t values = own::values, others = 2 * values + n;
    if constexpr (I < 2 * values) {
      constexpr std::size_t k = I % values, half = I < values ? 0 : motion::values;
      return gathered<Real, Width>(s.of.data(), [&](const member& of) {
        if constexpr (own::is_in_one_piece) return m.values_of_joints[half + of.value + k];
        else return m.values_of_joints[half + static_cast<std::size_t>(own::value[k])];
      });
    } else if constexpr (I < others) {
      constexpr std::size_t k = I - 2 * values;
      return gathered<Real, Width>(s.of.data(), [&](const member& of) {
        if constexpr (own::is_in_one_piece) return m.speeds[of.row + k];
        else return m.speeds[static_cast<std::size_t>(own::row[k])];
      });
    } else {
      return gathered<Real, Width>(s.of.data(), [&](const member&) {
        return I < others + 3 ? m.turning[(I - others) % 3] : m.up[(I - others) % 3];
      });
    }
  }

  // Of coordinate I, if some limb has another sign than its model.
  template <int I>
  [[gnu::always_inline]] static void turn(number& x, const some& s) {
    if constexpr (I >= 0)
      if constexpr (turns[static_cast<std::size_t>(I)])
        x = x * constant<constants + static_cast<std::size_t>(I)>(s);
  }
  using posture = posture_of_limbs<R, Real>;
  template <std::size_t O>
  [[gnu::always_inline]] static void store(number x, const some& s, posture& to) {
    constexpr std::size_t frames = 12 * own::links, forces = frames + n, entries = forces + own::entries;
    if constexpr (O >= frames && O < forces) {
      turn<static_cast<int>(O - frames)>(x, s);
      x = -x;
    } else if constexpr (O >= forces && O < entries) {
      constexpr auto place = own::places[O - forces];
      if constexpr (place.row != place.column)
        turn<place.row - tree::base>(x, s), turn<place.column - tree::base>(x, s);
    }
    for (std::size_t l = 0; l < Width; ++l) {
      const member& of = s.of[l];
      Real* place = nullptr;
      if constexpr (O < frames) {
        constexpr std::size_t i = O / 12, k = O % 12;
        auto& f = to.frames[own::is_in_one_piece ? of.link + i : static_cast<std::size_t>(own::link[i])];
        place = k < 9 ? &f.axes[k / 3 % 3][k % 3] : &f.at[k % 3];
      } else if constexpr (O < forces) {
        constexpr std::size_t i = O - frames;
        place = &to.forces[own::is_in_one_piece ? of.row + i : static_cast<std::size_t>(own::row[i])];
      } else if constexpr (O < entries) {
        constexpr std::size_t i = O - forces;
        constexpr int entry = own::places[i].entry;
        if constexpr (own::is_in_one_piece) place = &to.mass.entry[of.entry + i];
        else if constexpr (entry >= 0) place = &to.mass.entry[static_cast<std::size_t>(entry)];
      } else {
        constexpr std::size_t k = O - entries;
        auto& base = to.at_base[of.limb];
        place = k < 3    ? &base.load.moment[k % 3]
                : k < 6  ? &base.load.force[k % 3]
                : k < 12 ? &base.turning[(k - 6) % 6]
                         : &base.first[k % 3];
      }
      if (place == nullptr) continue;
      if constexpr (Width == 1) *place = x;
      else *place = x[l];
    }
  }

  // In lists, not folds: docs/compilers.md.
  template <int... I, int... C, int... O, int... Out>
  [[gnu::always_inline]] static void all(const motion& m,
                                         const some& s,
                                         posture& to,
                                         std::integer_sequence<int, I...>,
                                         std::integer_sequence<int, C...>,
                                         std::integer_sequence<int, O...>,
                                         std::integer_sequence<int, Out...>) {
    number v[std::size_t{rows + 1}];
    const bool done[]{(v[I] = input<static_cast<std::size_t>(I)>(m, s), true)...,
                      (v[t.inputs + C] = constant<static_cast<std::size_t>(C)>(s), true)...,
                      (cca::detail::operate<tape, O>(v), true)...,
                      (store<static_cast<std::size_t>(Out)>(
                           cca::detail::number_on_tape<t.output[static_cast<std::size_t>(Out)]>(v), s, to),
                       true)...};
    (void)done;
  }
  [[gnu::noinline]] static void compute(const motion& m, const some& s, posture& to) {
    all(m, s, to, std::make_integer_sequence<int, t.inputs>(), std::make_integer_sequence<int, t.constants>(),
        std::make_integer_sequence<int, t.operations>(), std::make_integer_sequence<int, t.outputs>());
  }

public:
  // From the member `First` of those with this code to the last that fills a vector.
  template <std::size_t First = 0>
  static void compute_all(const motion& m, posture& to) {
    constexpr std::size_t left = shared::template size<L> - First;
    if constexpr (left >= Width) {
      compute(m, some_of<First>, to);
      compute_all<First + Width>(m, to);
    } else if constexpr (left > 0) {
      limb_code<R, Real, L, 1>::template compute_all<First>(m, to);
    }
  }
};

// In loops.
template <class R, class Real, std::size_t L>
constexpr void compute_in_loops(const motion_of_limbs<R, Real>& m, posture_of_limbs<R, Real>& to) {
  using own = limb<R, L>;
  constexpr auto at = [](int i) { return static_cast<std::size_t>(i); };
  std::array<Real, own::n> speeds{};
  for (std::size_t i = 0; i < own::n; ++i) speeds[i] = m.speeds[at(own::row[i])];
  const auto found = limb_dynamics<own, Real>::of(m.template values_of<own>(), speeds, m.turning, m.up);
  for (std::size_t i = 0; i < own::links; ++i) to.frames[at(own::link[i])] = found.frames[i];
  for (std::size_t i = 0; i < own::n; ++i)
    to.forces[at(own::row[i])] =
        Real(-own::sign_of(compiled_tree<R>::base + static_cast<int>(i))) * found.bias[i];
  for (std::size_t i = 0; i < own::entries; ++i) {
    const auto& place = own::places[i];
    if (place.entry < 0) continue;
    to.mass.entry[at(place.entry)] =
        Real(own::sign_of(place.row) * own::sign_of(place.column)) * found.entries[i];
  }
  to.at_base[L] = found.at_base;
}

template <class R, class Real>
void compute_limbs(const motion_of_limbs<R, Real>& m, posture_of_limbs<R, Real>& to) {
  using shared = shared_limbs<R>;
  constexpr auto most = std::is_same_v<Real, double> ? std::size_t{cca::detail::lane_count} : std::size_t{1};
  cca::detail::unrolled<static_cast<int>(limbs_of<R>::count)>([&](auto l) {
    constexpr auto L = static_cast<std::size_t>(l());
    if constexpr (!shared::template is_recorded<L>) compute_in_loops<R, Real, L>(m, to);
    else if constexpr (shared::leader[L] == L)
      limb_code<R, Real, L, (shared::template size<L> >= most ? most : 1)>::compute_all(m, to);
  });
}

}  // namespace cca::sim::detail
