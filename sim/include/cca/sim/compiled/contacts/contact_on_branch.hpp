// What an impulse at a contact does to the branch of the tree that moves it, and the speed of the contact.
//
// The branch's rows of the contact's directions are taken through the factor of the step, so that products of
// two contacts' rows are the speed of one for an impulse at the other. What else it touches adds to it. Where
// a robot touches itself, a contact has a second branch: the same contact with the opposite axes.
#pragma once

#include <array>
#include <cstddef>

#include <cca/base/unrolled.hpp>
#include <cca/sim/compiled/contacts/contact_solver.hpp>
#include <cca/sim/compiled/limbs/straight_loops.hpp>
#include <cca/sim/compiled/on_links.hpp>
#include <cca/sim/compiled/probes.hpp>
#include <cca/sim/compiled/tree_step.hpp>

namespace cca::sim::detail {

template <class R, class Real>
struct contact_on_branch {
  using tree = compiled_tree<R>;
  using probes = probes_of<R>;
  static constexpr std::size_t longest = probes::longest > static_cast<std::size_t>(tree::base)
                                             ? probes::longest
                                             : static_cast<std::size_t>(tree::base);
  using directions = std::array<std::array<Real, longest>, 3>;

  std::size_t length = 0;                     // rows of its branch
  triple<Real> axes[3]{};                     // normal, then two tangents, in the world
  directions w;                               // D^-1/2 L^-T J^T, over the rows of its branch
  std::array<Real, 2> slip_before{}, slip{};  // m/s along the tangents, before and after the step
  triple<Real> arms[2]{};  // of the balls that the normal points into and out of: from their centres, m
  Real loose[2]{};         // what balls add to the speed for an impulse of 1: along the normal, across

  // The speeds of one contact for impulses at another one.
  static constexpr contact_block<Real> with_common(const probe& one,
                                                   const probe& other,
                                                   const directions& a,
                                                   const directions& b) {
    constexpr auto base = static_cast<std::size_t>(tree::base);
    const std::size_t rows = shared(one.tip, other.tip);
    Real sums[9]{};
    const auto add = [&](std::size_t i) {
      for (std::size_t r = 0; r < 3; ++r)
        for (std::size_t s = 0; s < 3; ++s) sums[3 * r + s] = sums[3 * r + s] + a[r][i] * b[s][i];
    };
    cca::detail::unrolled<tree::base>([&](auto i) { add(static_cast<std::size_t>(i())); });
    for (std::size_t i = base; i < rows; ++i) add(i);
    contact_block<Real> block;
    for (std::size_t k = 0; k < 9; ++k) block[k] = sums[k];
    return block;
  }

  constexpr void set_tangents(const triple<Real>& n) {
    const auto steep = n[0] * n[0] > Real(0.5);
    const triple<Real> across{select(steep, Real(0.0), Real(1.0)), select(steep, Real(1.0), Real(0.0)),
                              Real(0.0)};
    const triple<Real> t = across - dot(across, n) * n;
    axes[0] = n, axes[1] = (Real(1.0) / root(dot(t, t))) * t, axes[2] = cross(n, axes[1]);
  }

  // Of the point `p` at `world`: what moves it, and how fast it is. `scale`: D^-1/2.
  constexpr void fill(const tree_step<R, Real>& step,
                      const probe& p,
                      const triple<Real>& world,
                      contact_law<Real>& l,
                      const typename on_links<R, Real>::vector& speed,
                      const typename on_links<R, Real>::vector& scale) {
    constexpr const auto& of = tree::branches;
    if (p.shape < 0) {  // nothing of the robot that moves
      length = 0, w = {}, slip_before = {};
      return;
    }
    const auto& way = of.way[static_cast<std::size_t>(p.tip)];
    length = static_cast<std::size_t>(of.depth[static_cast<std::size_t>(p.tip)] + 1);
    const triple<Real> at = along(step.base, world - step.base.at);
    triple<Real> d[3];
    for (std::size_t r = 0; r < 3; ++r) {
      w[r] = {};
      d[r] = along(step.base, axes[r]);
      if constexpr (tree::floats) {
        const triple<Real> moment = cross(at, d[r]);
        for (std::size_t k = 0; k < 3; ++k) w[r][k] = moment[k], w[r][3 + k] = d[r][k];
      }
    }
    on_links<R, Real>::each_joint(
        step.now.places(), p.link,
        [&](std::size_t row, const triple<Real>& axis, const triple<Real>& from, bool turns) {
          const triple<Real> moves = turns ? cross(axis, at - from) : axis;
          const auto k = static_cast<std::size_t>(of.depth[row]);
          for (std::size_t r = 0; r < 3; ++r) w[r][k] = w[r][k] + dot(d[r], moves);
        });
    with_length<is_length>(length, [&](auto whole) {
      constexpr auto size = static_cast<std::size_t>(whole());
      const Real* rows[size];
      triple<Real> before, now;
      each_of<size>([&](std::size_t k) {
        const auto row = static_cast<std::size_t>(way[k]);
        rows[k] = step.now.mass.row(row);
        const Real v = speed[row], dv = step.change[row];
        for (std::size_t r = 0; r < 3; ++r) now[r] = now[r] + w[r][k] * v;
        for (std::size_t r = 1; r < 3; ++r) before[r] = before[r] + w[r][k] * dv;
      });
      for (std::size_t r = 0; r < 3; ++r) l.speed[r] = now[r];
      for (std::size_t r = 1; r < 3; ++r) slip_before[r - 1] = now[r] - before[r];
      eliminate<size>(rows);
      each_of<size>([&](std::size_t k) {
        const Real by = scale[static_cast<std::size_t>(way[k])];
        for (std::size_t r = 0; r < 3; ++r) w[r][k] = w[r][k] * by;
      });
    });
  }
  // As the second branch of a contact. The speeds of both add up.
  constexpr void fill_second(const tree_step<R, Real>& step,
                             const probe& p,
                             const triple<Real>& world,
                             contact_on_branch& first,
                             contact_law<Real>& l,
                             const typename on_links<R, Real>::vector& speed,
                             const typename on_links<R, Real>::vector& scale) {
    contact_law<Real> own;
    for (std::size_t r = 0; r < 3; ++r) axes[r] = Real(-1.0) * first.axes[r];
    fill(step, p, world, own, speed, scale);
    for (std::size_t r = 0; r < 3; ++r) l.speed[r] = l.speed[r] + own.speed[r];
    for (std::size_t r = 0; r < 2; ++r) first.slip_before[r] = first.slip_before[r] + slip_before[r];
  }
  // Of a contact alone, its speeds for its own impulses: normal, tangents, normal with each, both tangents.
  using own_block = Real[6];
  constexpr void add_own(own_block& g) const {
    for (std::size_t i = 0; i < length; ++i) {
      const Real a = w[0][i], b = w[1][i], c = w[2][i];
      g[0] = g[0] + a * a, g[1] = g[1] + b * b, g[2] = g[2] + c * c;
      g[3] = g[3] + a * b, g[4] = g[4] + a * c, g[5] = g[5] + b * c;
    }
  }
  // What its two branches have in common.
  static constexpr void add_own(const contact_block<Real>& both, own_block& g) {
    for (std::size_t r = 0; r < 3; ++r) g[r] = g[r] + Real(2.0) * both[4 * r];
    g[3] = g[3] + both[1] + both[3], g[4] = g[4] + both[2] + both[6], g[5] = g[5] + both[5] + both[7];
  }
  // Turns the tangents until an impulse along one causes no speed along the other.
  constexpr void turn_tangents(contact_law<Real>& l, own_block& g, contact_on_branch* second = nullptr) {
    if (!l.is_cone) return l.take(g);
    const Real d = g[2] - g[1], twice = g[5] + g[5], size = larger(d, -d);
    const Real sign = select(d < Real(0.0), Real(-1.0), Real(1.0));
    const Real t = sign * twice / (size + root(larger(d * d + twice * twice, Real(1e-200))));
    const Real c = Real(1.0) / root(Real(1.0) + t * t), s = t * c;
    const auto turn = [&](auto& a, auto& b) {
      const auto before = a;
      a = c * before - s * b;
      b = s * before + c * b;
    };
    turn(axes[1], axes[2]);
    turn(l.speed[1], l.speed[2]);
    turn(slip_before[0], slip_before[1]);
    for (std::size_t i = 0; i < length; ++i) turn(w[1][i], w[2][i]);
    if (second)
      for (std::size_t i = 0; i < second->length; ++i) turn(second->w[1][i], second->w[2][i]);
    l.own = {g[0], g[1] - t * g[5], g[2] + t * g[5]};
    turn(g[3], g[4]);
    l.coupling = {g[3], g[4]};
  }

private:
  // w becomes L^-T w.
  template <std::size_t Size>
  constexpr void eliminate(const Real* const* rows) {
    each_of<Size>([&](auto before) {
      const std::size_t i = Size - 1 - static_cast<std::size_t>(before);
      triple<Real> own{w[0][i], w[1][i], w[2][i]};
      each_before<Size>(before, [&](std::size_t less) {
        const std::size_t k = Size - 1 - less;
        for (std::size_t r = 0; r < 3; ++r) own[r] = own[r] - rows[k][i] * w[r][k];
      });
      for (std::size_t r = 0; r < 3; ++r) w[r][i] = own[r];
    });
  }

  // The lengths that branches with probes have, in rows.
  static constexpr auto is_length = [] {
    std::array<bool, longest + 1> is{};
    for (const probe& p : probes::all)
      if (p.tip >= 0)
        is[static_cast<std::size_t>(tree::branches.depth[static_cast<std::size_t>(p.tip)]) + 1] = true;
    return is;
  }();

  // Of two branches: how many rows they have in common, from the first.
  static constexpr std::size_t shared(int a, int b) {
    const auto& of = tree::branches;
    const auto &one = of.way[static_cast<std::size_t>(a)], &other = of.way[static_cast<std::size_t>(b)];
    std::size_t k = 0;
    while (k < longest && static_cast<int>(k) <= of.depth[static_cast<std::size_t>(a)] &&
           static_cast<int>(k) <= of.depth[static_cast<std::size_t>(b)] && one[k] == other[k])
      ++k;
    return k;
  }
};

}  // namespace cca::sim::detail
