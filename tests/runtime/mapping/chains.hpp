// Chains for the tests of kinematics: a plane arm, redundant arms, one with a prismatic joint, one of six
// joints, and Oncilla's leg.
#pragma once

#include <cca/mapping/inverse_kinematics.hpp>
#include <cca/sim/oncilla/kinematics.hpp>

#include "spaces.hpp"

namespace mapping_test {

template <cca::fixed_string Name, int Low, int High>  // limits in hundredths of rad
struct turning : cca::dimension<Name> {
  static constexpr auto limits = cca::limits{cca::angle{Low / 100.0, High / 100.0}};
};
struct a1 : turning<"a1", -170, 170> {};
struct a2 : turning<"a2", -120, 150> {};
struct a3 : turning<"a3", -200, 30> {};
struct a4 : turning<"a4", -250, 250> {};
struct a5 : turning<"a5", -110, 110> {};
struct a6 : turning<"a6", -300, 300> {};
struct slide : cca::dimension<"slide"> {
  static constexpr auto limits = cca::limits{cca::length{-0.1, 0.3}};
};

using cca::along_x, cca::along_y, cca::along_z, cca::at, cca::prismatic, cca::revolute, cca::turned_about;

// In the plane of x and z.
struct plane_arm : cca::serial_chain<trunk, hip, cca::axes<a1, a2>> {
  static constexpr std::array joints{revolute(along_y), revolute(along_y, at(0.3, 0, 0))};
  static constexpr auto tip = at(0.2, 0, 0);
};
// Three joints for three coordinates, with skew axes, none along x, y or z.
struct skew_arm : cca::serial_chain<trunk, hip, cca::axes<a1, a2, a3>> {
  static constexpr std::array joints{revolute({0.1, 0.2, 1}, at(0.1, 0, 0.2)),
                                     revolute({0, 2, 0.3}, at(0, 0.1, 0.1) * turned_about({1, 1, 0}, 0.4)),
                                     revolute({-0.2, 1, 0}, at(0.3, 0.02, 0))};
  static constexpr auto tip = at(0.25, 0, 0.05) * turned_about(along_x, 1);
};
// Four joints for three coordinates, the last one prismatic.
struct sliding_arm : cca::serial_chain<trunk, hip, cca::axes<a1, a2, a4, slide>> {
  static constexpr std::array joints{revolute(along_z), revolute(along_y, at(0.1, 0, 0.1)),
                                     revolute(along_x, at(0.2, 0, 0)),
                                     prismatic({0, 1, 1}, at(0.2, 0, 0) * turned_about(along_y, -0.5))};
  static constexpr auto tip = at(0.1, 0, 0);
};
// Two sections that slide together, the second half as far as the first.
struct telescope : cca::serial_chain<trunk, hip, cca::axes<a1, slide>> {
  static constexpr std::array joints{revolute(along_z), prismatic(along_x, at(0.1, 0, 0)).driven_by(1),
                                     prismatic(along_x, at(0.1, 0, 0)).driven_by(1, 0.5, 0.02)};
  static constexpr auto tip = at(0.1, 0, 0);
};
// Six joints with a wrist.
struct whole_arm : cca::serial_chain<trunk, hip, cca::axes<a1, a2, a3, a4, a5, a6>> {
  static constexpr std::array joints{
      revolute(along_z, at(0, 0, 0.3)),  revolute(along_y), revolute(along_y, at(0.3, 0, 0)),
      revolute(along_x, at(0.25, 0, 0)), revolute(along_y), revolute(along_x)};
  static constexpr auto tip = at(0.1, 0, 0);
};

// The leg of the simulated robot with its limits, but with half the range inward, so that the sides differ.
inline constexpr cca::sim::oncilla_model oncilla = cca::sim::oncilla_defaults;
struct abduction : cca::dimension<"abduction"> {
  static constexpr auto limits =
      cca::limits{cca::angle{oncilla.abduction_range.low / 2, oncilla.abduction_range.high}};
};
struct hip_joint : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{oncilla.hip_range.low, oncilla.hip_range.high}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{oncilla.knee_range.low, oncilla.knee_range.high}};
};
constexpr cca::pantograph leg_on(double side) {
  return {.upper = oncilla.upper_length,
          .middle = oncilla.middle_length,
          .lower = oncilla.foot_lever(),
          .side = side};
}
constexpr cca::pantograph placed_leg(double side) {
  auto leg = leg_on(side);
  leg.hip = at(oncilla.hip_x, side * oncilla.hip_y, -0.02);
  return leg;
}
struct leg_in_plane : cca::pantograph_leg<hip, world, cca::axes<hip_joint, knee>, leg_on(1)> {};
struct left_leg : cca::pantograph_leg<trunk, world, cca::axes<abduction, hip_joint, knee>, placed_leg(1)> {};
struct right_leg : cca::pantograph_leg<trunk, world, cca::axes<abduction, hip_joint, knee>, placed_leg(-1)> {
};
// Legs on turned hips.
constexpr cca::pantograph turned_leg_by(const std::array<double, 3>& axis, double angle) {
  auto leg = leg_on(1);
  leg.hip = at(0.1, 0.05, 0.02) * turned_about(axis, angle);
  return leg;
}
struct pitched_leg
    : cca::pantograph_leg<trunk, world, cca::axes<hip_joint, knee>, turned_leg_by(along_y, 0.5)> {};
struct tilted_leg
    : cca::pantograph_leg<trunk, world, cca::axes<hip_joint, knee>, turned_leg_by(along_x, 0.5)> {};
struct splayed_leg
    : cca::pantograph_leg<trunk, world, cca::axes<hip_joint, knee>, turned_leg_by(along_z, -0.5)> {};
struct turned_leg : cca::pantograph_leg<trunk,
                                        world,
                                        cca::axes<abduction, hip_joint, knee>,
                                        turned_leg_by({1, 2, -1}, 0.7)> {};
// The same leg, but solved like any chain.
template <class Leg>
struct as_chain : cca::serial_chain<typename Leg::base, typename Leg::tip_frame, typename Leg::axes> {
  static constexpr auto joints = Leg::joints;
  static constexpr auto tip = Leg::tip;
};

template <class Chain>
struct angles_of : cca::space<cca::joint_angles, typename Chain::axes> {};

// Random angles within the limits, or a little beyond them if `part` is more than 1.
template <class Chain>
auto random_angles(laws::source& random, double part = 1) {
  using limits = cca::detail::chain_limits<Chain, angles_of<Chain>>;
  typename limits::vector q;
  for (int i = 0; i < limits::size; ++i) {
    const double middle = (limits::lower(i) + limits::upper(i)) / 2,
                 half = part * (limits::upper(i) - limits::lower(i)) / 2;
    q[i] = random(middle - half, middle + half);
  }
  return q;
}

template <class Chain>
bool within_limits(const typename cca::detail::chain_limits<Chain, angles_of<Chain>>::vector& q) {
  return cca::detail::chain_limits<Chain, angles_of<Chain>>::clamped(q) == q;
}

}  // namespace mapping_test
