// Points on the links of a compiled world: where they are, how they move, and what a force on them does to
// the coordinates. Along the axes of the base.
#pragma once

#include <array>
#include <cstddef>

#include <cca/sim/compiled/compiled_tree.hpp>
#include <cca/sim/compiled/tree_motion.hpp>

namespace cca::sim::detail {

template <class R, class Real>
struct on_links {
  using tree = compiled_tree<R>;
  using frames = std::array<placed_frame<Real>, tree::links>;
  using vector = std::array<Real, static_cast<std::size_t>(tree::size)>;  // over the rows
  struct twist {
    triple<Real> turning, velocity;
  };

  static constexpr std::size_t row(int coordinate) {
    return static_cast<std::size_t>(tree::branches.row[static_cast<std::size_t>(tree::base + coordinate)]);
  }

  // Links whose frames here are turned as those of the description.
  static constexpr auto is_straight = [] {
    std::array<bool, tree::links> are{};
    for (std::size_t i = 0; i < tree::links; ++i)
      are[i] = tree::reduced.own[i] == cca::detail::constant33{1, 0, 0, 0, 1, 0, 0, 0, 1};
    return are;
  }();

  static constexpr triple<Real> point(const frames& at, int link, const std::array<double, 3>& p) {
    const triple<Real> v{Real(p[0]), Real(p[1]), Real(p[2])};
    if (link < 0) return v;
    const auto& f = at[static_cast<std::size_t>(link)];
    return f.at + f.direction(v);
  }

  // The frame of a place on a link, in the base.
  static constexpr placed_frame<Real> end_frame(const frames& at, const place_on_link& p) {
    placed_frame<Real> f;
    if (p.link >= 0) {
      const auto i = static_cast<std::size_t>(p.link);
      f = at[i];
      if (!is_straight[i]) f = f.turned_by(cca::detail::transposed(tree::reduced.own[i]));
    }
    f.at = point(at, p.link, tree::point(p));
    if (p.where.rotation == std::array<double, 4>{0, 0, 0, 1}) return f;
    return f.turned_by(cca::detail::matrix_of(p.where.rotation));
  }

  // f(row, axis of the joint times its ratio, where it is, whether it turns), from the link to the base.
  template <class F>
  static constexpr void each_joint(const frames& at, int link, F f) {
    for (int j = link; j >= 0;) {
      const auto& l = tree::reduced.links[static_cast<std::size_t>(j)];
      const auto& place = at[static_cast<std::size_t>(j)];
      f(row(l.coordinate), Real(l.ratio) * place.axes[l.axis], place.at, l.revolute);
      j = l.parent;
    }
  }

  // Of the point `p` of a link. `base`: of the base's origin.
  template <class Speeds>
  static constexpr twist motion(
      const frames& at, int link, const triple<Real>& p, const twist& base, const Speeds& dq) {
    twist t{base.turning, base.velocity + cross(base.turning, p)};
    for (int j = link; j >= 0;) {
      const auto& l = tree::reduced.links[static_cast<std::size_t>(j)];
      const auto& place = at[static_cast<std::size_t>(j)];
      const triple<Real> own =
          (Real(l.ratio) * dq[static_cast<std::size_t>(l.coordinate)]) * place.axes[l.axis];
      if (l.revolute) t.turning = t.turning + own, t.velocity = t.velocity + cross(own, p - place.at);
      else t.velocity = t.velocity + own;
      j = l.parent;
    }
    return t;
  }

  // Adds what a force at the point `p` of a link, and a torque on that link, do to each row.
  static constexpr void add_wrench(const frames& at,
                                   int link,
                                   const triple<Real>& p,
                                   const triple<Real>& force,
                                   const triple<Real>& torque,
                                   vector& rows) {
    if constexpr (tree::floats) {
      const triple<Real> moment = cross(p, force) + torque;
      for (std::size_t k = 0; k < 3; ++k) rows[k] = rows[k] + moment[k], rows[3 + k] = rows[3 + k] + force[k];
    }
    each_joint(at, link, [&](std::size_t r, const triple<Real>& axis, const triple<Real>& from, bool turns) {
      rows[r] = rows[r] + dot(axis, turns ? cross(p - from, force) + torque : force);
    });
  }
};

}  // namespace cca::sim::detail
