// A spring between the end of a part and a reference pose: force and torque from six stiffnesses along the
// axes of a frame.
//
//   const auto pull = cca::detail::cartesian_spring(end, pose, frame, stiffness, most)
//   pull.wrench    on the end: torque about its origin, then force, along the axes of the base
//   pull.cut       an axis is at `most` (torque, then force)
//
// `frame` has the principal axes as columns, along the axes of the base. With the rotation vector r and the
// displacement d from the reference, along them, and s = stiffness times both, each number cut to `most`:
//
//   force = -s,   torque = -(1 + [r]/2 + c [r]^2) s,   c = (1 - |r|/2 cot(|r|/2)) / |r|^2
//
// This is the gradient of a potential, so no closed path gives energy, also where it is cut and while the
// stiffnesses differ. About a principal axis the torque is the stiffness times the angle. At half a turn the
// shorter way, and with it the torque, changes its sign.
//
// NaN and infinity make results that are not finite; nothing is kept. Sources: Caccavale, Natale, Siciliano,
// Villani, Six-DOF Impedance Control Based on Angle/Axis Representations, IEEE Trans. Robotics and Automation
// 15(2), 1999; the inverse of the left Jacobian of SO(3): Sola, Deray, Atchuthan, A micro Lie theory for
// state estimation in robotics, 2018.
#pragma once

#include <cmath>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math.hpp>
#include <cca/robot/dynamics/spatial_inertia.hpp>

namespace cca::detail {

struct spring_pull {
  vector6 wrench;
  bool cut;
};

// What a torque along the changes of a rotation vector is about the axes: J^-T, J the left Jacobian.
inline vector3 torque_of_gradient(const vector3& r, const vector3& gradient) {
  const double square = math::dot(r, r), angle = math::sqrt(square);
  const double c = angle < 1e-3 ? 1.0 / 12 : (1 - 0.5 * angle / math::tan(0.5 * angle)) / square;
  const vector3 once = cross(r, gradient);
  return gradient + 0.5 * once + c * cross(r, once);
}

// The rotation vector from one orientation to another, along the axes of the base.
inline vector3 turn_from(const vector4& from, const vector4& to) {
  return rotation::log(rotation::product(to, rotation::inverse(from)));
}

inline spring_pull cartesian_spring(const rigid& end,
                                    const Eigen::Matrix<double, 7, 1>& reference,
                                    const matrix3& frame,
                                    const vector6& stiffness,
                                    const vector6& most) {
  const vector3 r = math::product(frame.transpose(), turn_from(reference.tail<4>(), quaternion_of(end.turn))),
                d = math::product(frame.transpose(), end.at - reference.head<3>());
  const vector6 pull = -stiffness.cwiseProduct(spatial(r, d)), cut = pull.cwiseMin(most).cwiseMax(-most);
  return {
      spatial(math::product(frame, torque_of_gradient(r, angular(cut))), math::product(frame, linear(cut))),
      cut != pull};
}

// G with the stiffness G G^T along the axes of the base.
inline matrix6 root_along(const matrix3& frame, const vector6& stiffness) {
  matrix6 root = matrix6::Zero();
  root.topLeftCorner<3, 3>() = frame * stiffness.head<3>().cwiseSqrt().asDiagonal();
  root.bottomRightCorner<3, 3>() = frame * stiffness.tail<3>().cwiseSqrt().asDiagonal();
  return root;
}

}  // namespace cca::detail
