#pragma once
// The Oncilla's legs as kinematic chains, with the lengths of its model.
#include <cstddef>

#include <cca/cca.hpp>
#include <cca/mapping/pantograph.hpp>
#include <cca/sim/oncilla_model.hpp>

#include "spaces.hpp"

namespace skills {

constexpr cca::pantograph leg_geometry(std::size_t leg) {
  constexpr const cca::sim::oncilla_model& m = cca::sim::oncilla_defaults;
  const double side = cca::sim::side_of(leg);
  return {.upper = m.upper_length,
          .middle = m.middle_length,
          .lower = m.foot_lever(),
          .side = side,
          .hip = cca::at((cca::sim::is_front(leg) ? m.hip_x : -m.hip_x) - m.trunk_forward_of_hips,
                         side * m.hip_y, -m.trunk_above_hips)};
}

template <std::size_t Leg, class Joints>
struct leg_chain : cca::pantograph_leg<trunk_frame, foot_frame, typename Joints::axes, leg_geometry(Leg)> {
  using joints_of = Joints;
};

struct left_front : leg_chain<0, left_front_joints> {};
struct right_front : leg_chain<1, right_front_joints> {};
struct left_hind : leg_chain<2, left_hind_joints> {};
struct right_hind : leg_chain<3, right_hind_joints> {};

inline Eigen::Vector3d hip_in_trunk(std::size_t leg) {
  const auto at = leg_geometry(leg).hip.translation;
  return {at[0], at[1], at[2]};
}

}  // namespace skills
