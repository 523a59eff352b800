// Springs and cables between two points of a compiled world.
//
// A line is seen in the middle of the step: its length and how the coordinates change it. Within the step its
// direction stays; its length follows the coordinates, as a joint's spring does (joint_forces.hpp). Points
// that lie on each other have no direction, so no force.
#pragma once

#include <array>
#include <cstddef>

#include <cca/sim/compiled/joint_forces.hpp>
#include <cca/sim/compiled/on_links.hpp>
#include <cca/sim/compiled/tree_equations.hpp>

namespace cca::sim::detail {

template <class R, class Real>
struct line_in_step {
  using tree = compiled_tree<R>;
  using coordinates = typename tree_equations<R, Real>::coordinates;
  using frames = std::array<placed_frame<Real>, tree::links>;
  using line = line_in_tree<tree::links>;

  const line* of = nullptr;
  coordinate_in_step<Real> length{};  // its `v` is how fast the line grows
  coordinates growth{};               // m for each rad of a coordinate
  straight_force<Real> force{};       // that makes it longer
  Real stretch{}, lengthens{};        // beyond its rest where the step feels it, and by how much for dv

  constexpr line_in_step() = default;
  // Positions in the base; `speeds` at the beginning of the step.
  // `inertia(c)`: of all that a coordinate moves.
  template <class Inertia>
  constexpr line_in_step(
      const line& l, const frames& at, const coordinates& speeds, Inertia inertia, double h)
      : of(&l) {
    const triple<Real> a = on_links<R, Real>::point(at, l.from, l.from_at),
                       b = on_links<R, Real>::point(at, l.to, l.to_at), whole = b - a;
    const Real square = dot(whole, whole);
    const auto exists = square > Real(0.0);
    const Real size = root(select(exists, square, Real(1.0)));
    const triple<Real> along = (select(exists, Real(1.0), Real(0.0)) / size) * whole;
    length.h = h, length.q = select(exists, size, Real(0.0));
    for (std::size_t i = 0; i < tree::links; ++i) {
      if (l.side[i] == 0) continue;
      const auto& j = tree::reduced.links[i];
      const triple<Real>& axis = at[i].axes[j.axis];
      const triple<Real> arm = (l.side[i] > 0 ? b : a) - at[i].at;
      const Real moves = dot(along, j.revolute ? cross(axis, arm) : axis);
      Real& g = growth[static_cast<std::size_t>(j.coordinate)];
      g = g + Real(l.side[i] * j.ratio) * moves;
    }
    Real ease(1e-300);
    for (int k = 0; k < l.count; ++k) {
      const auto c = static_cast<std::size_t>(l.coordinate[static_cast<std::size_t>(k)]);
      length.v = length.v + growth[c] * speeds[c];
      ease = ease + growth[c] * growth[c] / inertia(c);
    }
    length.inertia = Real(1.0) / ease;
    const Real stiffness(l.stiffness), damping(l.damping), theta = length.theta(stiffness, damping);
    force = soft_law<Real>{Real(l.rest), Real(0.0), Real(0.0), stiffness, damping}.in(length);
    stretch = length.position(theta, Real(0.0)) - Real(l.rest);
    lengthens = Real(0.5 * h) * theta;
  }

  // The force that makes it longer (negative: it pulls).
  constexpr answer<Real> at(const Real& dv) const {
    const answer<Real> soft = force.at(dv);
    if (!of->only_pulls) return soft;
    const auto pulls = stretch + lengthens * dv > Real(0.0);
    const auto taut = soft.force < Real(0.0);
    return {select(pulls, select(taut, soft.force, Real(0.0)), Real(0.0)),
            select(pulls, select(taut, soft.slope, Real(0.0)), Real(0.0))};
  }
};

}  // namespace cca::sim::detail
