#pragma once
// The Oncilla's legs as kinematic chains, with the lengths of its body.
#include <cstddef>

#include <cca/cca.hpp>
#include <cca/robots/oncilla/kinematics.hpp>

#include "spaces.hpp"

namespace skills {

template <std::size_t Leg, class Joints>
struct leg_chain
    : cca::pantograph_leg<trunk_frame, foot_frame, typename Joints::axes, oncilla::leg_geometry(Leg)> {
  using joints_of = Joints;
};

struct left_front : leg_chain<0, left_front_joints> {};
struct right_front : leg_chain<1, right_front_joints> {};
struct left_hind : leg_chain<2, left_hind_joints> {};
struct right_hind : leg_chain<3, right_hind_joints> {};

inline Eigen::Vector3d hip_in_trunk(std::size_t leg) {
  const auto at = oncilla::leg_geometry(leg).hip.translation;
  return {at[0], at[1], at[2]};
}

}  // namespace skills
