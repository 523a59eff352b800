// The mass matrix of a body.
//
//   const cca::body_pose<arm_body> now(q);
//   cca::mass_matrix(now)            n x n over axes_of<arm_body>: kg m^2 (rows and columns of prismatic
//                                    joints: kg and kg m); the base does not move
//   cca::floating_mass_matrix(now)   (6 + n) x (6 + n): the first six are the motion of the base, angular
//                                    velocity and velocity of its origin, along its axes
//
// Kinetic energy = dq^T M dq / 2; M is symmetric. It is positive definite if each coordinate moves mass.
// Coordinates that drive several joints are summed (virtual work).
// An angle that is NaN or infinite makes entries that are not finite. Nothing is kept, and no status says so:
// check it before (input_status.hpp).
// Source: composite rigid body algorithm, Featherstone, Rigid Body Dynamics Algorithms, 2008, section 6.2;
// floating base: section 9.3. Checked against Orocos KDL on random bodies. Nothing allocates. Cost: linear in
// the number of links, plus six products for each pair of a link and a link on its way to the base.
#pragma once

#include <cca/base/math/reductions.hpp>
#include <cca/robot/dynamics/spatial_inertia.hpp>

namespace cca {
namespace detail {

template <int Size, std::size_t Count>
Eigen::Matrix<double, Size, Size> joint_space_inertia(const std::array<body_link, Count>& links,
                                                      const composite_bodies<Count>& bodies) {
  Eigen::Matrix<double, Size, Size> m = Eigen::Matrix<double, Size, Size>::Zero();
  for (std::size_t i = 0; i < Count; ++i) {
    const int row = links[i].coordinate;
    m(row, row) += power(bodies.motion[i], bodies.load[i]);
    for (int j = links[i].parent; j >= 0; j = links[static_cast<std::size_t>(j)].parent) {
      const int column = links[static_cast<std::size_t>(j)].coordinate;
      const double of_both = power(bodies.motion[static_cast<std::size_t>(j)], bodies.load[i]);
      m(row, column) += of_both;
      m(column, row) += of_both;
    }
  }
  return m;
}

// With the base.
template <int Size, std::size_t Count>
Eigen::Matrix<double, 6 + Size, 6 + Size> whole_inertia(const std::array<body_link, Count>& links,
                                                        const composite_bodies<Count>& bodies) {
  Eigen::Matrix<double, 6 + Size, 6 + Size> m = Eigen::Matrix<double, 6 + Size, 6 + Size>::Zero();
  const matrix6 whole = bodies.all.matrix();
  m.template topLeftCorner<6, 6>() = 0.5 * (whole + whole.transpose());
  m.template bottomRightCorner<Size, Size>() = joint_space_inertia<Size>(links, bodies);
  for (std::size_t i = 0; i < Count; ++i)
    m.template topRightCorner<6, Size>().col(links[i].coordinate) += bodies.load[i];
  m.template bottomLeftCorner<Size, 6>() = m.template topRightCorner<6, Size>().transpose();
  return m;
}

}  // namespace detail

template <Body Type>
auto mass_matrix(const body_pose<Type>& now) {
  constexpr const auto& links = detail::weighed_links_of<Type>;
  constexpr int n = body_pose<Type>::size;
  using quantity = detail::recorded_mass_matrix<Type, false>;
  if constexpr (detail::is_recorded<quantity>()) {
    return detail::recorded_result<quantity, Eigen::Matrix<double, n, n>>(now.joint_values());
  } else {
    return detail::joint_space_inertia<n>(links,
                                          detail::composite_bodies<links.size()>(links, now.links(), {}));
  }
}

template <Body Type>
auto floating_mass_matrix(const body_pose<Type>& now) {
  constexpr int n = body_pose<Type>::size;
  constexpr const auto& links = detail::weighed_links_of<Type>;
  using quantity = detail::recorded_mass_matrix<Type, true>;
  if constexpr (detail::is_recorded<quantity>()) {
    return detail::recorded_result<quantity, Eigen::Matrix<double, 6 + n, 6 + n>>(now.joint_values());
  } else {
    return detail::whole_inertia<n>(
        links, detail::composite_bodies<links.size()>(links, now.links(), detail::base_inertia_of<Type>()));
  }
}

}  // namespace cca
