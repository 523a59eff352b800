// The equations of motion of a described robot at one posture: M a = forces, along the axes of its base.
//
//   tree_equations<R, double> now;
//   now.look(q);                                    the joints at these angles
//   now.weigh(speeds, turning, up);                 M and the forces that motion and gravity leave
//   now.mass.factor(); now.mass.solve(now.forces);  accelerations
//
// The algorithms are those of cca/robot/recorded, with the scalar of the world instead of a recorder:
// recursive Newton-Euler for the forces, composite bodies for M. Cost: linear in the links, but for pairs of
// links on one branch.
#pragma once

#include <array>
#include <cstddef>

#include <cca/base/math/angles.hpp>
#include <cca/sim/compiled/compiled_tree.hpp>
#include <cca/sim/compiled/tree_motion.hpp>

namespace cca::sim::detail {

template <class R, class Real>
struct tree_equations {
  using tree = compiled_tree<R>;
  using coordinates = std::array<Real, static_cast<std::size_t>(tree::coordinates)>;
  static constexpr const auto& rows = tree::branches;

  std::array<cca::detail::placed_joint<Real>, tree::links> joints{};
  branch_matrix<rows, Real> mass{};
  typename branch_matrix<rows, Real>::vector forces{};

  constexpr void look(const coordinates& q) {
    constexpr const auto& body = tree::reduced;
    std::array<Real, std::size_t{2 * body.value_count}> values{};
    for (int k = 0; k < body.value_count; ++k) {
      const auto& v = body.values[static_cast<std::size_t>(k)];
      const Real x = Real(v.ratio) * q[static_cast<std::size_t>(v.coordinate)];
      Real &first = values[static_cast<std::size_t>(k)],
           &second = values[static_cast<std::size_t>(k + body.value_count)];
      if (v.revolute) {
        using cca::math::sine_and_cosine;
        const auto both = sine_and_cosine(x);
        first = both.cosine, second = both.sine;
      } else {
        first = x;
      }
    }
    joints = cca::detail::placed_joints<Real>(body, values);
  }

  // Of the reduced links, in the base.
  constexpr std::array<placed_frame<Real>, tree::links> places() const {
    std::array<bool, tree::links> all{};
    for (bool& is_wanted : all) is_wanted = true;
    return cca::detail::placed_frames(tree::reduced, joints, all);
  }

  // `turning`: of the base; `up`: gravity taken from its acceleration, both along its axes.
  constexpr void weigh(const coordinates& speeds, const triple<Real>& turning, const triple<Real>& up) {
    constexpr std::size_t base = tree::base;
    cca::detail::link_motion<Real> root;
    root.w = turning, root.a = up;
    coordinates bias{};
    const auto load = cca::detail::add_newton_euler(tree::reduced, joints, root, speeds, coordinates{}, bias);
    if constexpr (tree::floats)
      for (std::size_t k = 0; k < 3; ++k) forces[k] = -load.moment[k], forces[3 + k] = -load.force[k];
    for (std::size_t c = 0; c < bias.size(); ++c)
      forces[static_cast<std::size_t>(rows.row[base + c])] = -bias[c];

    cca::detail::square<Real, tree::size> m;
    cca::detail::add_mass_matrix<tree::floats>(tree::reduced, joints, m);
    for (std::size_t k = 0; k < forces.size(); ++k) {
      Real* const own = mass.row(k);
      for (std::size_t a = 0; a <= static_cast<std::size_t>(rows.depth[k]); ++a)
        own[a] = m(rows.variable[k], rows.variable[static_cast<std::size_t>(rows.way[k][a])]);
    }
  }
};

}  // namespace cca::sim::detail
