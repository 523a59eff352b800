// Forward dynamics of a body: the accelerations that torques cause.
//
//   const cca::body_pose<arm_body> now(q);
//   cca::forward_dynamics(now, dq, torques, base)    ddq over axes_of<arm_body>: rad/s^2 (prismatic: m/s^2);
//                                                    the base moves as `base` says (body_dynamics.hpp)
//   cca::floating_forward_dynamics(now, dq, torques, base, wrench)
//                                                    .accelerations, and .base with the accelerations of a
//                                                    base that nothing holds but `wrench`: torque about its
//                                                    origin, then force, along its axes; of `base` it takes
//                                                    gravity and angular velocity
//
// It is the inverse of `inverse_dynamics`. A wrench f on the end of a part adds J^T f to the torques.
// Precondition: each coordinate moves mass, also alone (a weightless last link can't be accelerated by a
// finite torque); else the results are not finite.
// Numbers that are NaN or infinite make results that are not finite. Nothing is kept, and no status says so:
// check them before (input_status.hpp).
// Sources: articulated body algorithm, Featherstone, Rigid Body Dynamics Algorithms, 2008, section 7.3;
// floating base: section 9.4. A body with coupled joints, where the algorithm does not apply, takes the mass
// matrix instead (section 6.1). Cost: linear in the number of joints; nothing allocates.
#pragma once

#include <cca/base/math/reductions.hpp>
#include <cca/robot/dynamics/mass_matrix.hpp>
#include <cca/base/math/positive_matrix.hpp>

namespace cca {

template <int Size>
struct forward_dynamics_result {
  Eigen::Matrix<double, Size, 1> accelerations;
  base_motion base;
};

namespace detail {

// Several joints of one coordinate.
template <std::size_t Count>
constexpr bool has_coupled_joints(const std::array<body_link, Count>& links) {
  for (std::size_t i = 0; i < Count; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (links[i].coordinate == links[j].coordinate) return true;
  return false;
}

// Featherstone's U and D of a joint, and what its torque leaves over; c is its velocity-product acceleration.
struct articulated_joint {
  vector6 motion, load, c;
  double inverse = 0, torque = 0;
};

// Free: the base is accelerated by its wrench; else as `base` says.
template <bool Free, int Size, std::size_t Count>
forward_dynamics_result<Size> articulated_body(const std::array<body_link, Count>& links,
                                               const std::array<placed_link, Count>& placed,
                                               const link_inertia& base_weight,
                                               const Eigen::Matrix<double, Size, 1>& dq,
                                               const Eigen::Matrix<double, Size, 1>& torques,
                                               const base_motion& base,
                                               const vector6& wrench) {
  // In an inertial frame in which the base's origin rests for now; gravity is an acceleration upward.
  const vector6 root = spatial(base.angular_velocity, vector3::Zero());
  std::array<vector6, Count> v, bias;
  std::array<matrix6, Count> inertia;
  std::array<articulated_joint, Count> joints;
  for (std::size_t i = 0; i < Count; ++i) {
    const body_link& l = links[i];
    articulated_joint& j = joints[i];
    const vector6& before = l.parent < 0 ? root : v[static_cast<std::size_t>(l.parent)];
    j.motion = motion_of(l, placed[i]);
    const vector6 own = dq[l.coordinate] * j.motion;
    v[i] = before + own;
    j.c = cross_motion(before, own);
    const spatial_inertia of(l.inertia, placed[i].frame);
    inertia[i] = of.matrix();
    bias[i] = cross_load(v[i], of * v[i]);
  }

  const spatial_inertia of_base(base_weight);
  matrix6 base_inertia = of_base.matrix();
  vector6 base_bias = cross_load(root, of_base * root) - wrench;
  for (std::size_t i = Count; i-- > 0;) {
    const body_link& l = links[i];
    articulated_joint& j = joints[i];
    j.load = math::product(inertia[i], j.motion);
    j.inverse = 1 / power(j.motion, j.load);
    j.torque = torques[l.coordinate] - power(j.motion, bias[i]);
    if (!Free && l.parent < 0) continue;
    const vector6 part = j.inverse * j.load;
    inertia[i].noalias() -= part * j.load.transpose();
    bias[i] += math::product(inertia[i], j.c) + j.torque * part;
    (l.parent < 0 ? base_inertia : inertia[static_cast<std::size_t>(l.parent)]) += inertia[i];
    (l.parent < 0 ? base_bias : bias[static_cast<std::size_t>(l.parent)]) += bias[i];
  }

  forward_dynamics_result<Size> result;
  result.base = base;
  vector6 of_root = spatial(base.angular_acceleration, base.acceleration - base.gravity);
  if constexpr (Free) {
    of_root = -positive_matrix<6>(base_inertia).solve(base_bias);
    result.base.angular_acceleration = angular(of_root);
    result.base.acceleration = linear(of_root) + base.gravity;
  }
  std::array<vector6, Count> a;
  for (std::size_t i = 0; i < Count; ++i) {
    const body_link& l = links[i];
    const articulated_joint& j = joints[i];
    a[i] = (l.parent < 0 ? of_root : a[static_cast<std::size_t>(l.parent)]) + j.c;
    const double ddq = j.inverse * (j.torque - power(j.load, a[i]));
    a[i] += ddq * j.motion;
    result.accelerations[l.coordinate] = ddq;
  }
  return result;
}

}  // namespace detail

template <Body Type>
typename body_pose<Type>::vector_type forward_dynamics(
    const body_pose<Type>& now,
    const typename body_pose<Type>::vector_type& velocities,
    const typename body_pose<Type>::vector_type& torques,
    const base_motion& base) {
  constexpr const auto& links = detail::weighed_links_of<Type>;
  using vector = typename body_pose<Type>::vector_type;
  using quantity = detail::recorded_forward_dynamics<Type, true>;
  if constexpr (detail::is_recorded<quantity>()) {
    return detail::recorded_result<quantity, vector>(
        now.joint_values(), velocities.data(), torques.data(), base.gravity.data(),
        base.angular_velocity.data(), base.angular_acceleration.data(), base.acceleration.data());
  } else if constexpr (detail::has_coupled_joints(links)) {
    const vector bias = inverse_dynamics(now, velocities, vector(vector::Zero()), base).torques;
    return detail::positive_matrix<body_pose<Type>::size>(mass_matrix(now)).solve(vector(torques - bias));
  } else {
    return detail::articulated_body<false>(links, now.links(), {}, velocities, torques, base,
                                           detail::vector6(detail::vector6::Zero()))
        .accelerations;
  }
}
template <Body Type>
typename body_pose<Type>::vector_type forward_dynamics(
    const body_pose<Type>& now,
    const typename body_pose<Type>::vector_type& velocities,
    const typename body_pose<Type>::vector_type& torques) {
  constexpr bool weighs = detail::weighed<Type>::has_inertia;
  using quantity = detail::recorded_forward_dynamics<Type, false>;
  if constexpr (weighs && detail::is_recorded<quantity>()) {
    return detail::recorded_result<quantity, typename body_pose<Type>::vector_type>(
        now.joint_values(), velocities.data(), torques.data());
  } else {
    return forward_dynamics(now, velocities, torques, base_motion{});
  }
}

template <Body Type>
auto floating_forward_dynamics(
    const body_pose<Type>& now,
    const typename body_pose<Type>::vector_type& velocities,
    const typename body_pose<Type>::vector_type& torques,
    const base_motion& base = {},
    const Eigen::Matrix<double, 6, 1>& wrench = Eigen::Matrix<double, 6, 1>::Zero()) {
  constexpr const auto& links = detail::weighed_links_of<Type>;
  constexpr int n = body_pose<Type>::size;
  using quantity = detail::recorded_floating_forward_dynamics<Type>;
  if constexpr (detail::is_recorded<quantity>()) {
    forward_dynamics_result<n> result;
    result.base = base;
    detail::straight_line<quantity>::evaluate(
        {result.accelerations.data(), result.base.angular_acceleration.data(),
         result.base.acceleration.data()},
        now.joint_values(), velocities.data(), torques.data(), base.angular_velocity.data(), wrench.data(),
        wrench.data() + 3);
    result.base.acceleration += base.gravity;
    return result;
  } else if constexpr (detail::has_coupled_joints(links)) {
    base_motion still = base;
    still.angular_acceleration.setZero();
    still.acceleration.setZero();
    const auto bias = inverse_dynamics(now, velocities, body_pose<Type>::vector_type::Zero(), still);
    Eigen::Matrix<double, 6 + n, 1> load;
    load << wrench - bias.wrench, torques - bias.torques;
    load = detail::positive_matrix<6 + n>(floating_mass_matrix(now)).solve(load);
    forward_dynamics_result<n> result{load.template tail<n>(), base};
    result.base.angular_acceleration = load.template head<3>();
    result.base.acceleration = load.template segment<3>(3);
    return result;
  } else {
    return detail::articulated_body<true>(links, now.links(), detail::base_inertia_of<Type>(), velocities,
                                          torques, base, wrench);
  }
}

}  // namespace cca
