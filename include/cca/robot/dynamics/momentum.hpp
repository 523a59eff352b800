// The momentum of a body: of its coordinates, and about its centre of mass.
//
//   const cca::body_pose<arm_body> now(q);
//   cca::joint_momentum(now, dq).momentum       M(q) dq over axes_of<arm_body>, N m s (prismatic: N s)
//   cca::joint_momentum(now, dq).change         its change by the motion alone: C(q, dq)^T dq, N m
//   cca::centroidal_momentum(now, dq, base)     angular momentum about the centre of mass in N m s, then
//                                               linear momentum in N s, along the axes of the base
//   cca::centroidal_momentum_matrix(now)        6 x n: centroidal momentum = A dq, if the base does not move
//   cca::floating_centroidal_momentum_matrix(now)   6 x (6 + n), for the motion of the base, then dq
//
// `base` is the motion of the base: angular velocity, then the velocity of its origin, along its axes.
// d/dt (M dq) = torques + change - gravity torques + external torques: the momentum observer uses that.
// `change` is also the derivative of the kinetic energy with respect to q.
//
// Numbers that are NaN or infinite make results that are not finite. Nothing is kept, and no status says so:
// check them before (input_status.hpp).
//
// The matrices of Coriolis and mass are not needed: with the momentum h of all links behind a joint, its
// motion s, and v of the link, momentum = s h and change = (v x s) h. Cost: linear in the number of joints;
// nothing allocates. Sources: De Luca and Mattone, Sensorless Robot Collision Detection and Hybrid
// Force/Motion Control, ICRA 2005 (momentum of the coordinates); Orin and Goswami, Centroidal Momentum Matrix
// of a Humanoid Robot: Structure and Properties, IROS 2008.
#pragma once

#include <cca/base/math/reductions.hpp>
#include <cca/robot/dynamics/spatial_inertia.hpp>
#include <cca/robot/recorded/joint_momentum.hpp>

namespace cca {

template <int Size>
struct joint_momentum_result {
  Eigen::Matrix<double, Size, 1> momentum, change;
};

namespace detail {

// The momentum of a link that moves like this. In the axes of the link its inertia is constant.
inline vector6 momentum_of(const link_inertia& of, const rigid& where, const vector6& v) {
  const vector3 c = where.at + math::product(where.turn, as_vector(of.centre)), w = angular(v);
  const vector3 along = of.mass * (linear(v) + cross(w, c));
  return spatial(
      math::product(where.turn, inertia_times(of.about_centre, math::product(where.turn.transpose(), w))) +
          cross(c, along),
      along);
}

template <int Size, std::size_t Count>
joint_momentum_result<Size> momentum_of_joints(const std::array<body_link, Count>& links,
                                               const std::array<placed_link, Count>& placed,
                                               const Eigen::Matrix<double, Size, 1>& dq) {
  std::array<vector6, Count> s, v, h;  // of each joint its motion, of each link its motion and momentum
  for (std::size_t i = 0; i < Count; ++i) {
    s[i] = motion_of(links[i], placed[i]);
    v[i] = dq[links[i].coordinate] * s[i];
    if (links[i].parent >= 0) v[i] += v[static_cast<std::size_t>(links[i].parent)];
    h[i] = momentum_of(links[i].inertia, placed[i].frame, v[i]);
  }
  joint_momentum_result<Size> result;
  result.momentum.setZero();
  result.change.setZero();
  for (std::size_t i = Count; i-- > 0;) {
    result.momentum[links[i].coordinate] += power(s[i], h[i]);
    result.change[links[i].coordinate] += power(cross_motion(v[i], s[i]), h[i]);
    if (links[i].parent >= 0) h[static_cast<std::size_t>(links[i].parent)] += h[i];
  }
  return result;
}

// A momentum about the base's origin, about another point. Also for the columns of a matrix.
template <class Momenta>
void move_to_point(Momenta& h, const vector3& point) {
  h.template topRows<3>() -= math::product(skew(point), h.template bottomRows<3>());
}

template <std::size_t Count>
vector3 centre_of(const composite_bodies<Count>& bodies) {
  return bodies.all.mass > 0 ? vector3(bodies.all.moment / bodies.all.mass) : vector3::Zero();
}

template <int Size, std::size_t Count>
Eigen::Matrix<double, 6, 6 + Size> momentum_matrix(const std::array<body_link, Count>& links,
                                                   const composite_bodies<Count>& bodies) {
  Eigen::Matrix<double, 6, 6 + Size> a = Eigen::Matrix<double, 6, 6 + Size>::Zero();
  a.template leftCols<6>() = bodies.all.matrix();
  for (std::size_t i = 0; i < Count; ++i) a.col(6 + links[i].coordinate) += bodies.load[i];
  move_to_point(a, centre_of(bodies));
  return a;
}

}  // namespace detail

template <Body Type>
auto joint_momentum(const body_pose<Type>& now, const typename body_pose<Type>::vector_type& velocities) {
  constexpr bool weighs = detail::weighed<Type>::has_inertia;
  constexpr int n = body_pose<Type>::size;
  using quantity = detail::recorded_joint_momentum<Type>;
  if constexpr (weighs && detail::is_recorded<quantity>()) {
    joint_momentum_result<n> result;
    detail::straight_line<quantity>::evaluate({result.momentum.data(), result.change.data()},
                                              now.joint_values(), velocities.data());
    return result;
  } else {
    return detail::momentum_of_joints<n>(detail::weighed_links_of<Type>, now.links(), velocities);
  }
}

template <Body Type>
Eigen::Matrix<double, 6, 1> centroidal_momentum(
    const body_pose<Type>& now,
    const typename body_pose<Type>::vector_type& velocities,
    const Eigen::Matrix<double, 6, 1>& base = Eigen::Matrix<double, 6, 1>::Zero()) {
  constexpr const auto& links = detail::weighed_links_of<Type>;
  const auto v = detail::motions_of(links, now.links(), velocities, base);
  Eigen::Matrix<double, 6, 1> h = detail::spatial_inertia(detail::base_inertia_of<Type>()) * base;
  for (std::size_t i = 0; i < links.size(); ++i)
    h += detail::momentum_of(links[i].inertia, now.links()[i].frame, v[i]);
  detail::move_to_point(h, now.centre_of_mass());
  return h;
}

template <Body Type>
auto floating_centroidal_momentum_matrix(const body_pose<Type>& now) {
  constexpr const auto& links = detail::weighed_links_of<Type>;
  return detail::momentum_matrix<body_pose<Type>::size>(
      links, detail::composite_bodies<links.size()>(links, now.links(), detail::base_inertia_of<Type>()));
}

template <Body Type>
auto centroidal_momentum_matrix(const body_pose<Type>& now) {
  return typename body_pose<Type>::jacobian_type(
      floating_centroidal_momentum_matrix(now).template rightCols<body_pose<Type>::size>());
}

}  // namespace cca
