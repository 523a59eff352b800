// The two angles of hinges that cross at right angles, with a link without mass between them
// (cca/robots/crossing.hpp), from the rotations of the bodies on both sides.
#pragma once

#include <cca/base/math/reductions.hpp>
#include <cca/base/math.hpp>
#include <cca/mapping/kinematics.hpp>
#include <cca/robot/dynamics/spatial_inertia.hpp>

namespace cca::sim {

struct crossing_angles {
  double first, second;  // from (-pi, pi]
};

// With R(a, q) a turn about a by q:  below^T above = turn_1 R(axis_1, q_1) turn_2 R(axis_2, q_2). Each turn
// leaves its own axis as it is, so the other axis shows its angle.
inline crossing_angles crossing_of(const cca::detail::body_link& first,
                                   const cca::detail::body_link& second,
                                   const Eigen::Matrix3d& below,
                                   const Eigen::Matrix3d& above) {
  using cca::detail::as_vector, cca::detail::cross;
  const Eigen::Map<const Eigen::Matrix3d> turn_1(first.turn.data()), turn_2(second.turn.data());
  const Eigen::Vector3d axis_1 = as_vector(first.axis), axis_2 = as_vector(second.axis);
  const Eigen::Matrix3d between = (below * turn_1).transpose() * above;
  const Eigen::Vector3d was_2 = turn_2 * axis_2, is_2 = between * axis_2;
  const Eigen::Vector3d was_1 = turn_2.transpose() * axis_1, is_1 = between.transpose() * axis_1;
  return {math::atan2(math::dot(axis_1, cross(was_2, is_2)), math::dot(was_2, is_2)),
          math::atan2(math::dot(axis_2, cross(is_1, was_1)), math::dot(was_1, is_1))};
}

}  // namespace cca::sim
