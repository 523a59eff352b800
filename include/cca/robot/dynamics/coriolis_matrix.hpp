// Coriolis and centrifugal terms of a body whose base does not move.
//
//   const cca::body_pose<arm_body> now(q);
//   cca::coriolis_torques(now, dq)   C(q, dq) dq over axes_of<arm_body>: N m (prismatic: N)
//   cca::coriolis_matrix(now, dq)    C(q, dq): of the many that give these torques, the one made of
//                                    Christoffel symbols, so that dM/dt - 2 C is skew-symmetric
//
// If only the torques are needed, take the first: it is linear in the number of joints. With a base that
// moves, take `inverse_dynamics` with accelerations of zero. Nothing allocates.
// Numbers that are NaN or infinite make results that are not finite. Nothing is kept, and no status says so:
// check them before (input_status.hpp).
// Sources: torques: Newton-Euler (body_dynamics.hpp). Matrix: Echeandia and Wensing, Numerical Methods to
// Compute the Coriolis Matrix and Christoffel Symbols for Rigid-Body Systems, J. Computational and Nonlinear
// Dynamics 16(9), 2021, algorithm 1, here with B = integral of P^T dP/dt over the mass, where P v is the
// velocity of a particle: half of the 6 x 6 matrix is zero then.
#pragma once

#include <cca/base/math/reductions.hpp>
#include <cca/robot/dynamics/spatial_inertia.hpp>
#include <cca/robot/recorded/torque_derivatives.hpp>

namespace cca {
namespace detail {

// The Coriolis factor of bodies that move: its product with a motion is (turning w, w x momentum).
struct coriolis_factor {
  matrix3 turning = matrix3::Zero();
  vector3 momentum = vector3::Zero();  // linear, kg m/s

  coriolis_factor() = default;
  coriolis_factor(const spatial_inertia& of, const vector6& v) {
    const vector3 w = angular(v), u = linear(v);
    // The second moment of the mass about the base's origin.
    const matrix3 second = 0.5 * math::trace(of.about) * matrix3::Identity() - of.about;
    turning = -u * of.moment.transpose() - math::product(skew(w), second);
    turning.diagonal().array() += math::dot(of.moment, u);
    momentum = of.mass * u - cross(of.moment, w);
  }
  coriolis_factor& operator+=(const coriolis_factor& b) {
    turning += b.turning;
    momentum += b.momentum;
    return *this;
  }
  vector6 times(const vector6& m) const {
    const vector3 w = angular(m);
    return spatial(math::product(turning, w), cross(w, momentum));
  }
  vector6 transposed_times(const vector6& m) const {
    return spatial(math::product(turning.transpose(), angular(m)) + cross(momentum, linear(m)),
                   vector3::Zero());
  }
};

template <int Size, std::size_t Count>
Eigen::Matrix<double, Size, Size> coriolis_of(const std::array<body_link, Count>& links,
                                              const std::array<placed_link, Count>& placed,
                                              const Eigen::Matrix<double, Size, 1>& dq) {
  const auto v = motions_of(links, placed, dq);
  std::array<vector6, Count> s, change;  // of each joint: its motion and how that changes
  std::array<spatial_inertia, Count> inertia;
  std::array<coriolis_factor, Count> factor;
  for (std::size_t i = 0; i < Count; ++i) {
    s[i] = motion_of(links[i], placed[i]);
    change[i] = cross_motion(v[i], s[i]);
    inertia[i] = {links[i].inertia, placed[i].frame};
    factor[i] = {inertia[i], v[i]};
  }
  Eigen::Matrix<double, Size, Size> c = Eigen::Matrix<double, Size, Size>::Zero();
  for (std::size_t i = Count; i-- > 0;) {
    const vector6 across = inertia[i] * change[i] + factor[i].times(s[i]);
    const vector6 load = inertia[i] * s[i], back = factor[i].transposed_times(s[i]);
    const int own = links[i].coordinate;
    c(own, own) += power(s[i], across);
    for (int p = links[i].parent; p >= 0; p = links[static_cast<std::size_t>(p)].parent) {
      const auto j = static_cast<std::size_t>(p);
      c(links[j].coordinate, own) += power(s[j], across);
      c(own, links[j].coordinate) += power(change[j], load) + power(s[j], back);
    }
    if (links[i].parent < 0) continue;
    inertia[static_cast<std::size_t>(links[i].parent)] += inertia[i];
    factor[static_cast<std::size_t>(links[i].parent)] += factor[i];
  }
  return c;
}

}  // namespace detail

template <Body Type>
auto coriolis_torques(const body_pose<Type>& now, const typename body_pose<Type>::vector_type& velocities) {
  constexpr bool weighs = detail::weighed<Type>::has_inertia;
  using vector = typename body_pose<Type>::vector_type;
  using quantity = detail::recorded_coriolis_torques<Type>;
  if constexpr (weighs && detail::is_recorded<quantity>()) {
    return detail::recorded_result<quantity, vector>(now.joint_values(), velocities.data());
  } else {
    base_motion weightless;
    weightless.gravity.setZero();
    return vector(inverse_dynamics(now, velocities, vector(vector::Zero()), weightless).torques);
  }
}

template <Body Type>
auto coriolis_matrix(const body_pose<Type>& now, const typename body_pose<Type>::vector_type& velocities) {
  constexpr bool weighs = detail::weighed<Type>::has_inertia;
  constexpr int n = body_pose<Type>::size;
  using quantity = detail::recorded_coriolis_matrix<Type>;
  if constexpr (weighs && detail::is_recorded<quantity>()) {
    return detail::recorded_result<quantity, Eigen::Matrix<double, n, n>>(now.joint_values(),
                                                                          velocities.data());
  } else {
    return detail::coriolis_of<n>(detail::weighed_links_of<Type>, now.links(), velocities);
  }
}

}  // namespace cca
