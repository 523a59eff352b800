// The equations of motion of a described robot at one posture: M a = forces, along the axes of its base.
//
//   tree_equations<R, double> now;
//   now.look(q);                                    the joints at these angles
//   now.weigh(speeds, turning, up);                 M, the forces that motion and gravity leave, and where
//                                                   the links are (`places()`)
//   limb_solution<R, double>::factor_and_solve(now.mass, now.forces);   accelerations
//
// The algorithms are those of cca/robot/recorded, limb by limb (limbs/limb_code.hpp): recursive Newton-Euler
// for the forces, composite bodies for M. Cost: linear in the links, but for pairs of links on one branch.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <cca/base/compiler.hpp>
#include <cca/base/math/angles.hpp>
#include <cca/sim/compiled/compiled_tree.hpp>
#include <cca/sim/compiled/slots.hpp>
#include <cca/sim/compiled/limbs/limb_code.hpp>
#include <cca/sim/compiled/tree_motion.hpp>

namespace cca::sim::detail {

template <class R, class Real>
struct tree_equations {
  using tree = compiled_tree<R>;
  using coordinates = std::array<Real, static_cast<std::size_t>(tree::coordinates)>;
  static constexpr const auto& rows = tree::branches;
  using frames = std::array<placed_frame<Real>, tree::links>;

  motion_of_limbs<R, Real> motion{};
  branch_matrix<rows, Real> mass;  // `weigh` writes all of it
  typename branch_matrix<rows, Real>::vector forces{};

  // Of the reduced links, in the base, once they are weighed.
  const frames& places() const { return places_[0]; }

  constexpr void look(const coordinates& q) {
    constexpr std::size_t values = motion_of_limbs<R, Real>::values;
    std::array<Real, values> x{};
    for (std::size_t k = 0; k < values; ++k)
      x[k] = Real(factor[k]) * q[static_cast<std::size_t>(tree::reduced.values[k].coordinate)];
    std::size_t done = 0;
    if constexpr (std::is_same_v<Real, double>) {
      constexpr auto together = static_cast<std::size_t>(cca::detail::lane_count);
      for (; done + together <= values; done += together) {
        cca::detail::lanes some{};
        for (std::size_t l = 0; l < together; ++l) some[l] = x[done + l];
        const auto both = cca::math::sine_and_cosine(some);
        for (std::size_t l = 0; l < together; ++l) set(done + l, both.cosine[l], both.sine[l]);
      }
    }
    for (; done < values; ++done) {
      using cca::math::sine_and_cosine;
      const auto both = sine_and_cosine(x[done]);
      set(done, both.cosine, both.sine);
    }
    for (std::size_t k = 0; k < values; ++k)
      if (!tree::reduced.values[k].revolute) set(k, x[k], Real(0.0));
  }

  // Where the links are, without `weigh`.
  constexpr frames only_places() const {
    frames found;
    cca::detail::unrolled<static_cast<int>(limbs_of<R>::count)>([&](auto l) {
      using own = limb<R, static_cast<std::size_t>(l())>;
      const auto some = limb_dynamics<own, Real>::frames_of(
          cca::detail::placed_joints<Real>(own::body, motion.template values_of<own>()));
      for (std::size_t i = 0; i < own::links; ++i) found[static_cast<std::size_t>(own::link[i])] = some[i];
    });
    return found;
  }

  // `turning`: of the base; `up`: gravity taken from its acceleration, both along its axes.
  constexpr void weigh(const coordinates& speeds, const triple<Real>& turning, const triple<Real>& up) {
    for (std::size_t c = 0; c < speeds.size(); ++c)
      motion.speeds[static_cast<std::size_t>(rows.row[tree::base + c])] =
          Real(limbs_of<R>::sign[c]) * speeds[c];
    motion.turning = turning, motion.up = up;
    std::array<load_of_limb<Real>, limbs_of<R>::count> at_base;
    if constexpr (!limbs_write_all) mass.entry = {};
    posture_of_limbs<R, Real> to{places_[0], mass, forces, at_base};
    compute_limbs(motion, to);
    if constexpr (tree::floats) weigh_base(at_base);
  }

private:
  // Whether each entry of M is the base's or a limb's; else some are zero.
  static constexpr bool limbs_write_all = []<std::size_t... L>(std::index_sequence<L...>) {
    std::array<bool, static_cast<std::size_t>(rows.entries)> written{};
    for (int k = 0; k < tree::base * (tree::base + 1) / 2; ++k) written[static_cast<std::size_t>(k)] = true;
    const auto write = [&](const auto& of_limb) {
      for (const auto& p : of_limb)
        if (p.entry >= 0) written[static_cast<std::size_t>(p.entry)] = true;
    };
    (write(limb<R, L>::places), ...);
    for (const bool is : written)
      if (!is) return false;
    return true;
  }(std::make_index_sequence<limbs_of<R>::count>());

  // What an angle is of its coordinate, with the sign of the limb's model.
  static constexpr auto factor = [] {
    std::array<double, motion_of_limbs<R, Real>::values> of{};
    for (std::size_t k = 0; k < of.size(); ++k) {
      const auto& v = tree::reduced.values[k];
      of[k] = v.ratio * (v.revolute ? limbs_of<R>::sign[static_cast<std::size_t>(v.coordinate)] : 1.0);
    }
    return of;
  }();
  constexpr void set(std::size_t k, const Real& first, const Real& second) {
    motion.values_of_joints[k] = first, motion.values_of_joints[motion.values + k] = second;
  }

  // The base alone, and what the limbs add.
  constexpr void weigh_base(const std::array<load_of_limb<Real>, limbs_of<R>::count>& limbs) {
    constexpr const auto& of = tree::reduced.base;
    const triple<Real> h{Real(of.first[0]), Real(of.first[1]), Real(of.first[2])};
    load_of_limb<Real> all;
    const Real xx(of.second[1] + of.second[2]), yy(of.second[0] + of.second[2]),
        zz(of.second[0] + of.second[1]), xy(-of.second[3]), xz(-of.second[4]), yz(-of.second[5]);
    all.turning = {xx, xy, yy, xz, yz, zz}, all.first = h;
    const triple<Real>&w = motion.turning, &a = motion.up;
    const triple<Real> spin{xx * w[0] + xy * w[1] + xz * w[2], xy * w[0] + yy * w[1] + yz * w[2],
                            xz * w[0] + yz * w[1] + zz * w[2]};
    all.load.force = Real(of.mass) * a + cross(w, cross(w, h));
    all.load.moment = cross(h, a) + cross(w, spin);
    for (const auto& l : limbs) {
      all.load.moment = all.load.moment + l.load.moment, all.load.force = all.load.force + l.load.force;
      all.first = all.first + l.first;
      for (std::size_t k = 0; k < 6; ++k) all.turning[k] = all.turning[k] + l.turning[k];
    }
    for (std::size_t k = 0; k < 3; ++k) forces[k] = -all.load.moment[k], forces[3 + k] = -all.load.force[k];
    for (std::size_t k = 0; k < 6; ++k) mass.entry[k] = all.turning[k];
    const Real zero(0.0), whole(tree::mass);
    const auto& f = all.first;
    const Real below[15]{zero,  f[2], -f[1], whole, -f[2], zero, f[0], zero,
                         whole, f[1], -f[0], zero,  zero,  zero, whole};
    for (std::size_t k = 0; k < 15; ++k) mass.entry[6 + k] = below[k];
  }

  slots<frames, 1> places_;  // 2 kB that are not cleared first
};

}  // namespace cca::sim::detail
