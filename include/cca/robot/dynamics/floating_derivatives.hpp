// The derivatives of the dynamics of a body whose base is free: how the accelerations of the joints and of
// the base change with angles, velocities, torques and with the motion of the base.
//
//   const cca::body_pose<dog> now(q);
//   cca::floating_forward_dynamics_derivatives(now, dq, torques, base, wrench)
//       .accelerations, .base                     as floating_forward_dynamics gives them
//       .by_angles, .by_velocities, .by_torques   (6 + n) x n
//       .by_wrench                                (6 + n) x 6: torque about the base's origin, then force
//       .by_angular_velocity, .by_orientation     (6 + n) x 3: of the base
//   cca::floating_inverse_dynamics_derivatives(now, dq, ddq, base)
//       .torques, .wrench                         as inverse_dynamics gives them
//       .by_angles, .by_velocities                (6 + n) x n
//       .by_angular_velocity, .by_orientation     (6 + n) x 3: of the base
//       .by_accelerations                         (6 + n) x (6 + n): the floating mass matrix
//
// Rows, and columns where there are 6 + n, are those of floating_mass_matrix: the base, angular part first,
// then the coordinates. All vectors of the base are along its own axes, as in `base_motion`: also what a
// derivative is taken of, and by. What is not the variable is kept as numbers along those axes: wrench,
// angular velocity, accelerations.
// Orientation: the tangent space is the base's own. A small turn t (rad, about the axes of the base) takes
// the orientation R of the base to R exp(t x); only gravity sees it, and changes by gravity x t. The place
// and the linear velocity of the base change nothing, so they have no columns.
// `.base.acceleration` is that of the base's origin, along the axes of a base that turns: the velocity u
// along the same axes changes by it less angular velocity x u.
//
// Precondition of forward dynamics: each coordinate moves mass, and so does the base with all of them.
// Numbers that are NaN or infinite make results that are not finite: an angle, a velocity, a torque all of
// those that depend on it, gravity only `by_orientation` and the acceleration of the base. Nothing is kept,
// and no status says so: check them before (input_status.hpp).
// Cost: a loop over each pair of a link and a link on its way to the base, then the inverse of the mass
// matrix. Nothing allocates. Not part of cca/robot.hpp: include it where you need it.
// Sources: recorded/torque_derivatives.hpp, where the base is a joint of six axes; derivatives.hpp.
#pragma once

#include <cca/base/math/reductions.hpp>
#include <cca/robot/dynamics/derivatives.hpp>

namespace cca {

template <int Size>
struct floating_inverse_dynamics_derivatives_result {
  Eigen::Matrix<double, Size, 1> torques;
  Eigen::Matrix<double, 6, 1> wrench;
  Eigen::Matrix<double, 6 + Size, Size> by_angles, by_velocities;
  Eigen::Matrix<double, 6 + Size, 3> by_angular_velocity, by_orientation;
  Eigen::Matrix<double, 6 + Size, 6 + Size> by_accelerations;
};
template <int Size>
struct floating_forward_dynamics_derivatives_result : forward_dynamics_result<Size> {
  Eigen::Matrix<double, 6 + Size, Size> by_angles, by_velocities, by_torques;
  Eigen::Matrix<double, 6 + Size, 6> by_wrench;
  Eigen::Matrix<double, 6 + Size, 3> by_angular_velocity, by_orientation;
};

template <Body Type>
auto floating_inverse_dynamics_derivatives(const body_pose<Type>& now,
                                           const typename body_pose<Type>::vector_type& velocities,
                                           const typename body_pose<Type>::vector_type& accelerations,
                                           const base_motion& base) {
  constexpr const auto& links = detail::weighed_links_of<Type>;
  floating_inverse_dynamics_derivatives_result<body_pose<Type>::size> d;
  d.torques.setZero();
  d.by_angles.setZero(), d.by_velocities.setZero();
  d.by_angular_velocity.setZero(), d.by_accelerations.setZero();
  detail::differentiate_loads<6>(links, now.links(), detail::base_inertia_of<Type>(), velocities,
                                 accelerations, base, d);
  // What gravity adds to the loads is what the opposite acceleration of the base would.
  for (int k = 0; k < 3; ++k)
    d.by_orientation.col(k) = math::product(d.by_accelerations.template middleCols<3>(3),
                                            detail::cross(detail::vector3::Unit(k), base.gravity));
  return d;
}

template <Body Type>
auto floating_forward_dynamics_derivatives(
    const body_pose<Type>& now,
    const typename body_pose<Type>::vector_type& velocities,
    const typename body_pose<Type>::vector_type& torques,
    const base_motion& base = {},
    const Eigen::Matrix<double, 6, 1>& wrench = Eigen::Matrix<double, 6, 1>::Zero()) {
  constexpr int n = body_pose<Type>::size;
  using coordinates = detail::free_coordinates<Type>;
  floating_forward_dynamics_derivatives_result<n> d;
  static_cast<forward_dynamics_result<n>&>(d) =
      floating_forward_dynamics(now, velocities, torques, base, wrench);
  const auto inverse = floating_inverse_dynamics_derivatives(now, velocities, d.accelerations, d.base);
  const detail::inverse_of_mass<coordinates> mass(inverse.by_accelerations);
  mass.template write_minus_product<coordinates::by_coordinates>(inverse.by_angles, d.by_angles);
  mass.template write_minus_product<coordinates::by_coordinates>(inverse.by_velocities, d.by_velocities);
  mass.template write_minus_product<coordinates::by_base>(inverse.by_angular_velocity, d.by_angular_velocity);
  Eigen::Matrix<double, 6 + n, 6 + n> loads;
  mass.write(loads);
  d.by_wrench = loads.template leftCols<6>();
  d.by_torques = loads.template rightCols<n>();
  // A body that falls does not feel gravity: only the acceleration of its base turns with the base.
  d.by_orientation.setZero();
  d.by_orientation.template middleRows<3>(3) = detail::skew(base.gravity);
  return d;
}

}  // namespace cca
