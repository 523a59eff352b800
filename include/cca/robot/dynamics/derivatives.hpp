// The derivatives of inverse and forward dynamics: how torques and accelerations change with angles,
// velocities and with one another, for controllers that look ahead, estimators and identification.
//
//   const cca::body_pose<arm_body> now(q);
//   cca::inverse_dynamics_derivatives(now, dq, ddq, base)
//       .torques                                        as inverse_dynamics gives them
//       .by_angles, .by_velocities, .by_accelerations   n x n: row: torque, column: coordinate; the last one is
//                                                       the mass matrix
//   cca::forward_dynamics_derivatives(now, dq, torques, base)
//       .accelerations                                  as forward_dynamics gives them
//       .by_angles, .by_velocities, .by_torques         n x n; the last one is the inverse of the mass matrix
//
// Angles in rad (prismatic: m), the derivatives in the units of the quotient. They are exact: no step is
// chosen. The base moves as `base` says (body_dynamics.hpp), whatever the coordinates do; without it, it
// stands. A coordinate that drives several joints has the sum of their derivatives, times their ratios.
// Precondition of forward dynamics: each coordinate moves mass (forward_dynamics.hpp).
//
// Numbers that are NaN or infinite make results that are not finite. Nothing is kept, and no status says so:
// check them before (input_status.hpp).
// Cost: for an arm of seven joints 3.6 times inverse dynamics; recorded up to a size (recorded/), then a loop
// over each pair of a link and a link on its way to the base. Nothing allocates. Not part of cca/robot.hpp:
// include it where you need it.
// Sources: recorded/torque_derivatives.hpp. Forward: from M ddq + h = torques, d ddq = M^-1 (d torques - dh -
// dM ddq): Carpentier and Mansard, Analytical Derivatives of Rigid Body Dynamics Algorithms, Robotics:
// Science and Systems 2018.
#pragma once

#include <cca/base/math/reductions.hpp>
#include <cca/robot/dynamics/coriolis_matrix.hpp>
#include <cca/robot/dynamics/forward_dynamics.hpp>
#include <cca/robot/dynamics/inverse_of_mass.hpp>
#include <cca/robot/recorded/torque_derivatives.hpp>

namespace cca {

template <int Size>
struct inverse_dynamics_derivatives_result {
  Eigen::Matrix<double, Size, 1> torques;
  Eigen::Matrix<double, Size, Size> by_angles, by_velocities, by_accelerations;
};
template <int Size>
struct forward_dynamics_derivatives_result {
  Eigen::Matrix<double, Size, 1> accelerations;
  Eigen::Matrix<double, Size, Size> by_angles, by_velocities, by_torques;
};

namespace detail {

// As recorded/torque_derivatives.hpp, along the axes of the base. Adds to `d`. `First`: 6 if the rows and the
// columns of the accelerations begin with those of the base (floating_derivatives.hpp), else 0.
template <int First, std::size_t Count, class Vector, class Result>
void differentiate_loads(const std::array<body_link, Count>& links,
                         const std::array<placed_link, Count>& placed,
                         const link_inertia& base_weight,
                         const Vector& dq,
                         const Vector& ddq,
                         const base_motion& base,
                         Result& d) {
  std::array<vector6, Count> s, v, a, first, second, load;
  std::array<spatial_inertia, Count> inertia;
  std::array<coriolis_factor, Count> factor;
  const vector6 v_root = spatial(base.angular_velocity, vector3::Zero()),
                a_root = spatial(base.angular_acceleration, base.acceleration - base.gravity);
  for (std::size_t i = 0; i < Count; ++i) {
    const bool on_base = links[i].parent < 0;
    const auto p = static_cast<std::size_t>(on_base ? 0 : links[i].parent);
    const vector6 &v_before = on_base ? v_root : v[p], &a_before = on_base ? a_root : a[p];
    s[i] = motion_of(links[i], placed[i]);
    first[i] = cross_motion(v_before, s[i]);
    second[i] = cross_motion(a_before, s[i]) + cross_motion(v_before, first[i]);
    v[i] = v_before + dq[links[i].coordinate] * s[i];
    a[i] = a_before + ddq[links[i].coordinate] * s[i] + dq[links[i].coordinate] * first[i];
    inertia[i] = {links[i].inertia, placed[i].frame};
    factor[i] = {inertia[i], v[i]};
    load[i] = inertia[i] * a[i] + cross_load(v[i], inertia[i] * v[i]);
  }
  [[maybe_unused]] const vector3& w = base.angular_velocity;
  [[maybe_unused]] spatial_inertia all;
  [[maybe_unused]] coriolis_factor factor_of_all;
  [[maybe_unused]] vector6 load_on_base;
  if constexpr (First > 0) {
    all = spatial_inertia(base_weight);
    factor_of_all = {all, v_root};
    load_on_base = all * a_root + cross_load(v_root, all * v_root);
  }
  for (std::size_t i = Count; i-- > 0;) {
    const int own = links[i].coordinate, row = First + own;
    const vector6 pushed = inertia[i] * s[i], back = 2 * factor[i].transposed_times(s[i]),
                  by_speed = 2 * (factor[i].times(s[i]) + inertia[i] * first[i]),
                  standing = 2 * factor[i].times(first[i]) + inertia[i] * second[i],
                  by_angle = standing + cross_load(s[i], load[i]);
    d.torques[own] += power(s[i], load[i]);
    d.by_angles(row, own) += power(s[i], standing);
    d.by_velocities(row, own) += power(s[i], by_speed);
    d.by_accelerations(row, row) += power(s[i], pushed);
    for (int p = links[i].parent; p >= 0; p = links[static_cast<std::size_t>(p)].parent) {
      const auto j = static_cast<std::size_t>(p);
      const int other = links[j].coordinate, other_row = First + other;
      const double of_both = power(s[j], pushed);
      d.by_angles(other_row, own) += power(s[j], by_angle);
      d.by_angles(row, other) += power(first[j], back) + power(second[j], pushed);
      d.by_velocities(other_row, own) += power(s[j], by_speed);
      d.by_velocities(row, other) += power(s[j], back) + 2 * power(first[j], pushed);
      d.by_accelerations(other_row, row) += of_both;
      d.by_accelerations(row, other_row) += of_both;
    }
    if constexpr (First > 0) {
      d.by_angles.col(own).template head<6>() += by_angle;
      d.by_velocities.col(own).template head<6>() += by_speed;
      d.by_angular_velocity.row(row) += angular(back) + cross(angular(pushed), w);
      d.by_accelerations.col(row).template head<6>() += pushed;
      d.by_accelerations.row(row).template head<6>() += pushed;
    }
    if (links[i].parent >= 0) {
      const auto p = static_cast<std::size_t>(links[i].parent);
      load[p] += load[i], inertia[p] += inertia[i], factor[p] += factor[i];
    } else if constexpr (First > 0) {
      load_on_base += load[i], all += inertia[i], factor_of_all += factor[i];
    }
  }
  if constexpr (First > 0) {
    d.wrench = load_on_base;
    for (int k = 0; k < 3; ++k) {
      const vector6 turn = spatial(vector3::Unit(k), vector3::Zero()),
                    change = spatial(cross(w, vector3::Unit(k)), vector3::Zero());
      d.by_angular_velocity.col(k).template head<6>() = 2 * factor_of_all.times(turn) + all * change;
    }
    const matrix6 whole = all.matrix();
    d.by_accelerations.template topLeftCorner<6, 6>() = 0.5 * (whole + whole.transpose());
  }
}

template <int Size, std::size_t Count>
inverse_dynamics_derivatives_result<Size> derivatives_of_torques(const std::array<body_link, Count>& links,
                                                                 const std::array<placed_link, Count>& placed,
                                                                 const Eigen::Matrix<double, Size, 1>& dq,
                                                                 const Eigen::Matrix<double, Size, 1>& ddq,
                                                                 const base_motion& base) {
  inverse_dynamics_derivatives_result<Size> d;
  d.torques.setZero();
  d.by_angles.setZero(), d.by_velocities.setZero(), d.by_accelerations.setZero();
  differentiate_loads<0>(links, placed, {}, dq, ddq, base, d);
  return d;
}

template <class Type, bool Moving, class... Base>
auto recorded_derivatives(const body_pose<Type>& now,
                          const typename body_pose<Type>::vector_type& velocities,
                          const typename body_pose<Type>::vector_type& accelerations,
                          const Base&... base) {
  inverse_dynamics_derivatives_result<body_pose<Type>::size> d;
  straight_line<recorded_torque_derivatives<Type, Moving>>::evaluate(
      {d.torques.data(), d.by_angles.data(), d.by_velocities.data(), d.by_accelerations.data()},
      now.joint_values(), velocities.data(), accelerations.data(), base.data()...);
  return d;
}

}  // namespace detail

template <Body Type>
auto inverse_dynamics_derivatives(const body_pose<Type>& now,
                                  const typename body_pose<Type>::vector_type& velocities,
                                  const typename body_pose<Type>::vector_type& accelerations,
                                  const base_motion& base) {
  constexpr const auto& links = detail::weighed_links_of<Type>;
  constexpr int n = body_pose<Type>::size;
  if constexpr (detail::is_recorded<detail::recorded_torque_derivatives<Type, true>>()) {
    return detail::recorded_derivatives<Type, true>(now, velocities, accelerations, base.gravity,
                                                    base.angular_velocity, base.angular_acceleration,
                                                    base.acceleration);
  } else {
    return detail::derivatives_of_torques<n, links.size()>(links, now.links(), velocities, accelerations,
                                                           base);
  }
}
template <Body Type>
auto inverse_dynamics_derivatives(const body_pose<Type>& now,
                                  const typename body_pose<Type>::vector_type& velocities,
                                  const typename body_pose<Type>::vector_type& accelerations) {
  constexpr bool weighs = detail::weighed<Type>::has_inertia;
  if constexpr (weighs && detail::is_recorded<detail::recorded_torque_derivatives<Type, false>>()) {
    return detail::recorded_derivatives<Type, false>(now, velocities, accelerations);
  } else {
    return inverse_dynamics_derivatives(now, velocities, accelerations, base_motion{});
  }
}

namespace detail {

// d ddq = M^-1 (d torques - d(inverse dynamics)).
template <class Body, int Size>
forward_dynamics_derivatives_result<Size> derivatives_of_solution(
    const Eigen::Matrix<double, Size, 1>& accelerations,
    const inverse_dynamics_derivatives_result<Size>& inverse) {
  const inverse_of_mass<held_coordinates<Body>> mass(inverse.by_accelerations);
  forward_dynamics_derivatives_result<Size> d;
  d.accelerations = accelerations;
  mass.template write_minus_product<coupled_coordinates_of<Body>>(inverse.by_angles, d.by_angles);
  mass.template write_minus_product<coupled_coordinates_of<Body>>(inverse.by_velocities, d.by_velocities);
  mass.write(d.by_torques);
  return d;
}

}  // namespace detail

template <Body Type>
auto forward_dynamics_derivatives(const body_pose<Type>& now,
                                  const typename body_pose<Type>::vector_type& velocities,
                                  const typename body_pose<Type>::vector_type& torques,
                                  const base_motion& base) {
  const typename body_pose<Type>::vector_type accelerations =
      forward_dynamics(now, velocities, torques, base);
  return detail::derivatives_of_solution<Type>(
      accelerations, inverse_dynamics_derivatives(now, velocities, accelerations, base));
}
template <Body Type>
auto forward_dynamics_derivatives(const body_pose<Type>& now,
                                  const typename body_pose<Type>::vector_type& velocities,
                                  const typename body_pose<Type>::vector_type& torques) {
  const typename body_pose<Type>::vector_type accelerations = forward_dynamics(now, velocities, torques);
  return detail::derivatives_of_solution<Type>(accelerations,
                                               inverse_dynamics_derivatives(now, velocities, accelerations));
}

}  // namespace cca
