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

#include <cstring>

#include <cca/base/compiler.hpp>
#include <cca/base/inlining.hpp>
#include <cca/base/unrolled.hpp>
#include <cca/robot/dynamics/coriolis_matrix.hpp>
#include <cca/robot/dynamics/forward_dynamics.hpp>
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

// As recorded/torque_derivatives.hpp, along the axes of the base.
template <int Size, std::size_t Count>
inverse_dynamics_derivatives_result<Size> derivatives_of_torques(const std::array<body_link, Count>& links,
                                                                 const std::array<placed_link, Count>& placed,
                                                                 const Eigen::Matrix<double, Size, 1>& dq,
                                                                 const Eigen::Matrix<double, Size, 1>& ddq,
                                                                 const base_motion& base) {
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
  inverse_dynamics_derivatives_result<Size> d;
  d.torques.setZero();
  d.by_angles.setZero(), d.by_velocities.setZero(), d.by_accelerations.setZero();
  for (std::size_t i = Count; i-- > 0;) {
    const int own = links[i].coordinate;
    const vector6 pushed = inertia[i] * s[i], back = 2 * factor[i].transposed_times(s[i]),
                  by_speed = 2 * (factor[i].times(s[i]) + inertia[i] * first[i]),
                  standing = 2 * factor[i].times(first[i]) + inertia[i] * second[i],
                  by_angle = standing + cross_load(s[i], load[i]);
    d.torques[own] += s[i].dot(load[i]);
    d.by_angles(own, own) += s[i].dot(standing);
    d.by_velocities(own, own) += s[i].dot(by_speed);
    d.by_accelerations(own, own) += s[i].dot(pushed);
    for (int p = links[i].parent; p >= 0; p = links[static_cast<std::size_t>(p)].parent) {
      const auto j = static_cast<std::size_t>(p);
      const int other = links[j].coordinate;
      const double of_both = s[j].dot(pushed);
      d.by_angles(other, own) += s[j].dot(by_angle);
      d.by_angles(own, other) += first[j].dot(back) + second[j].dot(pushed);
      d.by_velocities(other, own) += s[j].dot(by_speed);
      d.by_velocities(own, other) += s[j].dot(back) + 2 * first[j].dot(pushed);
      d.by_accelerations(other, own) += of_both;
      d.by_accelerations(own, other) += of_both;
    }
    if (links[i].parent < 0) continue;
    const auto p = static_cast<std::size_t>(links[i].parent);
    load[p] += load[i], inertia[p] += inertia[i], factor[p] += factor[i];
  }
  return d;
}

// Which coordinates move one another: M is zero elsewhere, and so is its inverse.
template <int Size>
struct coordinate_pairs {
  bool all[std::size_t{Size * Size + 1}]{};
  constexpr bool& operator()(int a, int b) { return all[a * Size + b]; }
  constexpr bool operator()(int a, int b) const { return all[a * Size + b]; }
};
template <int Size, std::size_t Count>
constexpr coordinate_pairs<Size> coupled_coordinates(const std::array<body_link, Count>& links) {
  coordinate_pairs<Size> of;
  for (const body_link& l : links)
    for (int j = static_cast<int>(&l - links.data()); j >= 0; j = links[static_cast<std::size_t>(j)].parent) {
      const int other = links[static_cast<std::size_t>(j)].coordinate;
      of(l.coordinate, other) = of(other, l.coordinate) = true;
    }
  for (int k = 0; k < Size; ++k)
    for (int i = 0; i < Size; ++i)
      for (int j = 0; j < Size; ++j) of(i, j) = of(i, j) || (of(i, k) && of(k, j));
  return of;
}

template <class Body>
inline constexpr auto coupled_coordinates_of =
    coupled_coordinates<axes_of<Body>::count>(weighed_links_of<Body>);

// The inverse of a mass matrix, and its product with others: by columns, in the lanes of vectors. Gauss and
// Jordan; a positive definite matrix needs no other pivots. A NaN stays in the columns of its limb.
template <class Body>
class inverse_of_mass {
  static constexpr int size = axes_of<Body>::count, width = (size + lane_count - 1) / lane_count;
  static constexpr const auto& coupled = coupled_coordinates_of<Body>;
  using matrix = Eigen::Matrix<double, size, size>;
  struct column {
    lanes e[std::size_t{width + 1}]{};

    double at(int r) const { return e[r / lane_count][r % lane_count]; }
    void set(int r, double x) { e[r / lane_count][r % lane_count] = x; }
    CCA_INLINE void add(double factor, const column& c) {
      unrolled<width>([&](auto w) { e[w()] += factor * c.e[w()]; });
    }
    CCA_INLINE void write(int k, matrix& to) const {
      std::memcpy(to.data() + k * size, e, size * sizeof(double));
      for (int r = 0; r < size; ++r)
        if (!are_coupled(r, k)) to(r, k) = 0;
    }
  };
  CCA_INLINE static bool are_coupled(int r, int c) {
    constexpr bool always = [] {
      for (int k = 0; k < size * size; ++k)
        if (!coupled.all[k]) return false;
      return true;
    }();
    return always || coupled(r, c);
  }
  column columns[std::size_t{size + 1}];

public:
  explicit inverse_of_mass(const matrix& m) {
    for (int k = 0; k < size; ++k) std::memcpy(columns[k].e, m.data() + k * size, size * sizeof(double));
    for (int k = 0; k < size; ++k) {
      const column own = columns[k];
      const double inverse = 1 / own.at(k);
      for (int j = 0; j < size; ++j) {
        if (j == k || !are_coupled(j, k)) continue;
        const double factor = columns[j].at(k) * inverse;
        columns[j].add(-factor, own);
        columns[j].set(k, factor);
      }
      columns[k] = {};
      columns[k].add(-inverse, own);
      columns[k].set(k, inverse);
    }
  }
  void write(matrix& to) const {
    for (int k = 0; k < size; ++k) columns[k].write(k, to);
  }
  // - m^-1 b.
  void write_minus_product(const matrix& b, matrix& to) const {
    for (int c = 0; c < size; ++c) {
      column sum;
      for (int k = 0; k < size; ++k)
        if (are_coupled(k, c)) sum.add(-b(k, c), columns[k]);
      sum.write(c, to);
    }
  }
};

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
  const inverse_of_mass<Body> mass(inverse.by_accelerations);
  forward_dynamics_derivatives_result<Size> d;
  d.accelerations = accelerations;
  mass.write_minus_product(inverse.by_angles, d.by_angles);
  mass.write_minus_product(inverse.by_velocities, d.by_velocities);
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
