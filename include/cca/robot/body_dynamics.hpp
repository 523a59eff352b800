// Inverse dynamics of a body: the torques that a motion needs, and those that hold it against gravity.
//
//   const cca::body_pose<oncilla_body> now(q);
//   cca::inverse_dynamics(now, dq, ddq)                 over axes_of<oncilla_body>: N m (prismatic: N)
//   cca::inverse_dynamics(now, dq, ddq, base).wrench    on the base: torque about its origin, then force
//   cca::gravity_torques(now, gravity)                  the same at rest, in half the time
//
// `base` is the motion of the base and the direction of gravity, along the axes of the base. For a robot on
// the ground, gravity is (0, 0, -9.81) turned back by the orientation of the trunk. A wrench f on the end of
// a part adds -J^T f. Parts without `links` weigh nothing; a body of which all parts do is refused:
// body.no_inertia, also by the other headers of dynamics.
//
// Numbers that are NaN or infinite make results that are not finite. Nothing is kept, and no status says so:
// check them before (input_status.hpp).
//
// Source: the recursive Newton-Euler algorithm (Luh, Walker, Paul 1980; Featherstone, Rigid Body Dynamics
// Algorithms, 2008, section 5.3), all vectors along the axes of the base. Checked against Orocos KDL on
// random trees, and by power and energy. Cost: linear in the number of joints; nothing allocates.
#pragma once

#include <array>
#include <cstddef>

#include <cca/base/math/reductions.hpp>
#include <cca/robot/body_pose.hpp>
#include <cca/robot/recorded/quantities.hpp>

namespace cca {

struct base_motion {
  using vector = Eigen::Matrix<double, 3, 1>;
  vector gravity{0, 0, -9.81};                   // m/s^2
  vector angular_velocity = vector::Zero();      // rad/s
  vector angular_acceleration = vector::Zero();  // rad/s^2
  vector acceleration = vector::Zero();          // of the base's origin, without gravity, m/s^2
};

template <int Size>
struct dynamics_result {
  Eigen::Matrix<double, Size, 1> torques;
  Eigen::Matrix<double, 6, 1> wrench;
};

namespace detail {

inline matrix3 matrix_of(const std::array<double, 6>& i) {
  matrix3 m;
  m << i[0], i[3], i[4], i[3], i[1], i[5], i[4], i[5], i[2];
  return m;
}

// matrix_of(i) * w, without the matrix: it would be written to memory, and read again by lanes.
inline vector3 inertia_times(const std::array<double, 6>& i, const vector3& w) {
  using pair = some_lanes<2>::vector;
  const pair first{i[0], i[3]}, second{i[3], i[1]}, third{i[4], i[5]};
  const pair two = first * w[0] + (second * w[1] + third * w[2]);
  return {two[0], two[1], i[4] * w[0] + (i[5] * w[1] + i[2] * w[2])};
}

// A force on a body and its moment about a point.
struct load {
  vector3 force = vector3::Zero(), moment = vector3::Zero();
};

// The motion of a frame: angular velocity, angular acceleration, acceleration of the origin.
struct frame_motion {
  vector3 w, dw, a;
};

// The load that moves a body like this, about the origin of its frame (Newton and Euler).
inline load load_for(const link_inertia& of, const matrix3& turn, const frame_motion& m) {
  const vector3 c = math::product(turn, as_vector(of.centre));
  const vector3 acceleration =
      m.a + rotation::cross<double>(m.dw, c) + rotation::cross<double>(m.w, rotation::cross<double>(m.w, c));
  // In the axes of the body, where the inertia is constant.
  const vector3 dw = math::product(turn.transpose(), m.dw), w = math::product(turn.transpose(), m.w);
  const vector3 own =
      inertia_times(of.about_centre, dw) + rotation::cross<double>(w, inertia_times(of.about_centre, w));
  load l;
  l.force = of.mass * acceleration;
  l.moment = math::product(turn, own) + rotation::cross<double>(c, l.force);
  return l;
}

template <std::size_t Count, int Size>
dynamics_result<Size> newton_euler(const std::array<body_link, Count>& links,
                                   const std::array<placed_link, Count>& placed,
                                   const link_inertia& base_weight,
                                   const Eigen::Matrix<double, Size, 1>& dq,
                                   const Eigen::Matrix<double, Size, 1>& ddq,
                                   const base_motion& base) {
  const frame_motion root{base.angular_velocity, base.angular_acceleration, base.acceleration - base.gravity};
  std::array<frame_motion, Count> motion;
  std::array<load, Count> loads;
  std::array<vector3, Count> arms;  // from the origin of the link before

  for (std::size_t i = 0; i < Count; ++i) {
    const body_link& l = links[i];
    const auto before = static_cast<std::size_t>(l.parent);
    const frame_motion& p = l.parent < 0 ? root : motion[before];
    const vector3 r = l.parent < 0 ? placed[i].frame.at
                                   : vector3(placed[i].frame.at - placed[before].frame.at),
                  along = l.ratio * dq[l.coordinate] * placed[i].axis,
                  along_change = l.ratio * ddq[l.coordinate] * placed[i].axis;
    arms[i] = r;
    frame_motion& m = motion[i];
    m = p;
    m.a += rotation::cross<double>(p.dw, r) + rotation::cross<double>(p.w, rotation::cross<double>(p.w, r));
    if (l.kind == joint_kind::revolute) {
      m.w += along;
      m.dw += along_change + rotation::cross<double>(p.w, along);
    } else {
      m.a += along_change + 2 * rotation::cross<double>(p.w, along);
    }
    loads[i] = load_for(l.inertia, placed[i].frame.turn, m);
  }

  dynamics_result<Size> result;
  result.torques.setZero();
  load at_base = load_for(base_weight, matrix3::Identity(), root);
  for (std::size_t i = Count; i-- > 0;) {
    const body_link& l = links[i];
    result.torques[l.coordinate] +=
        l.ratio *
        math::dot(placed[i].axis, l.kind == joint_kind::revolute ? loads[i].moment : loads[i].force);
    load& below = l.parent < 0 ? at_base : loads[static_cast<std::size_t>(l.parent)];
    below.force += loads[i].force;
    below.moment += loads[i].moment + rotation::cross<double>(arms[i], loads[i].force);
  }
  result.wrench.template head<3>() = at_base.moment;
  result.wrench.template tail<3>() = at_base.force;
  return result;
}

// At rest only weights count: a joint carries the mass of all links behind it, at their common centre.
template <int Size, std::size_t Count>
Eigen::Matrix<double, Size, 1> torques_at_rest(const std::array<body_link, Count>& links,
                                               const std::array<placed_link, Count>& placed,
                                               const vector3& gravity) {
  std::array<double, Count> masses{};  // of the links behind each one, and mass times centre
  std::array<vector3, Count> moments;  // from the base's origin
  for (vector3& one : moments) one.setZero();
  Eigen::Matrix<double, Size, 1> torques = Eigen::Matrix<double, Size, 1>::Zero();
  for (std::size_t i = Count; i-- > 0;) {
    const body_link& l = links[i];
    const auto& [frame, axis] = placed[i];
    const double mass = l.inertia.mass + masses[i];
    const vector3 moment =
        l.inertia.mass * (frame.at + math::product(frame.turn, as_vector(l.inertia.centre))) + moments[i];
    if (l.kind == joint_kind::revolute)
      torques[l.coordinate] -=
          l.ratio * math::dot(axis, rotation::cross<double>(vector3(moment - mass * frame.at), gravity));
    else torques[l.coordinate] -= l.ratio * mass * math::dot(axis, gravity);
    if (l.parent >= 0) {
      masses[static_cast<std::size_t>(l.parent)] += mass;
      moments[static_cast<std::size_t>(l.parent)] += moment;
    }
  }
  return torques;
}

}  // namespace detail

template <Body Type>
auto inverse_dynamics(const body_pose<Type>& now,
                      const typename body_pose<Type>::vector_type& velocities,
                      const typename body_pose<Type>::vector_type& accelerations,
                      const base_motion& base) {
  constexpr const auto& links = detail::weighed_links_of<Type>;
  constexpr int n = body_pose<Type>::size;
  using quantity = detail::recorded_inverse_dynamics<Type, true>;
  if constexpr (detail::is_recorded<quantity>()) {
    dynamics_result<n> result;
    detail::straight_line<quantity>::evaluate(
        {result.torques.data(), result.wrench.data(), result.wrench.data() + 3}, now.joint_values(),
        velocities.data(), accelerations.data(), base.gravity.data(), base.angular_velocity.data(),
        base.angular_acceleration.data(), base.acceleration.data());
    return result;
  } else {
    return detail::newton_euler<links.size(), n>(links, now.links(), detail::base_inertia_of<Type>(),
                                                 velocities, accelerations, base);
  }
}
template <Body Type>
auto inverse_dynamics(const body_pose<Type>& now,
                      const typename body_pose<Type>::vector_type& velocities,
                      const typename body_pose<Type>::vector_type& accelerations) {
  constexpr bool weighs = detail::weighed<Type>::has_inertia;
  using quantity = detail::recorded_inverse_dynamics<Type, false>;
  if constexpr (weighs && detail::is_recorded<quantity>()) {
    dynamics_result<body_pose<Type>::size> result;
    detail::straight_line<quantity>::evaluate(
        {result.torques.data(), result.wrench.data(), result.wrench.data() + 3}, now.joint_values(),
        velocities.data(), accelerations.data());
    return result;
  } else {
    return inverse_dynamics(now, velocities, accelerations, base_motion{});
  }
}

// Gravity along the base's axes, m/s^2. Without this argument the base stands upright.
template <Body Type>
auto gravity_torques(const body_pose<Type>& now, const Eigen::Matrix<double, 3, 1>& gravity) {
  constexpr const auto& links = detail::weighed_links_of<Type>;
  constexpr int n = body_pose<Type>::size;
  using quantity = detail::recorded_gravity_torques<Type, true>;
  if constexpr (detail::is_recorded<quantity>()) {
    return detail::recorded_result<quantity, Eigen::Matrix<double, n, 1>>(now.joint_values(), gravity.data());
  } else {
    return detail::torques_at_rest<n>(links, now.links(), gravity);
  }
}
template <Body Type>
auto gravity_torques(const body_pose<Type>& now) {
  constexpr bool weighs = detail::weighed<Type>::has_inertia;
  using quantity = detail::recorded_gravity_torques<Type, false>;
  if constexpr (weighs && detail::is_recorded<quantity>()) {
    return detail::recorded_result<quantity, typename body_pose<Type>::vector_type>(now.joint_values());
  } else {
    return gravity_torques(now, base_motion{}.gravity);
  }
}

}  // namespace cca
