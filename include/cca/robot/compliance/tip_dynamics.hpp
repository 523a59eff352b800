// What the controllers of the end of a part share: its pose, its Jacobian, its mobility, and the joint
// torques that it does not feel.
//
//   const cca::detail::tip_dynamics_at<Body, "arm"> tip(q);
//   const cca::detail::tip_dynamics<Body, "arm"> tip(end, jacobian, mass);    of what is derived already
//   tip.end, tip.jacobian             rigid, 6 x n
//   tip.mass                          mass matrix, n x n, and its decomposition `tip.solver`
//   tip.mobility                      J M^-1 J^T: acceleration of the end per wrench
//   tip.free_torques(t)               the part of joint torques that does not accelerate the end
//   tip.free_momentum(dq)             M times the part of a motion that does not move the end
//
// NaN and infinity make results that are not finite; nothing is kept. Precondition: each coordinate moves
// mass. Source: operational_space.hpp.
#pragma once

#include <cca/base/math/reductions.hpp>
#include <cca/robot/compliance/compliance_spaces.hpp>
#include <cca/robot/dynamics/derived_mass.hpp>
#include <cca/robot/dynamics/operational_space.hpp>

namespace cca::detail {

template <class Body, fixed_string Part>
struct tip_dynamics {
  static constexpr int size = body_pose<Body>::size;
  using vector = Eigen::Matrix<double, size, 1>;
  using matrix = Eigen::Matrix<double, size, size>;

  const rigid& end;
  const Eigen::Matrix<double, 6, size>& jacobian;
  const matrix& mass;
  const positive_matrix<size>& solver;
  matrix6 mobility, inertia;

  // They must outlive this.
  tip_dynamics(const rigid& at, const Eigen::Matrix<double, 6, size>& moves, const decomposed_mass<size>& m)
      : end(at), jacobian(moves), mass(m.matrix), solver(m.solver) {
    const Eigen::Matrix<double, size, 6> half =
        solver.forward(Eigen::Matrix<double, size, 6>(jacobian.transpose()));
    mobility = math::product(half.transpose(), half);
    inertia = generalised_inverse<6>(mobility);
  }

  vector free_torques(const vector& t) const {
    return t - math::product(jacobian.transpose(),
                             math::product(inertia, math::product(jacobian, solver.solve(t))));
  }
  vector free_momentum(const vector& dq) const {
    return math::product(mass, dq) -
           math::product(jacobian.transpose(), math::product(inertia, math::product(jacobian, dq)));
  }
};

// With all that it is made of.
template <class Body, fixed_string Part>
struct parts_of_tip_dynamics {
  body_pose<Body> now;
  rigid own_end;
  typename body_pose<Body>::jacobian_type own_jacobian;
  decomposed_mass<body_pose<Body>::size> own_mass;

  explicit parts_of_tip_dynamics(const typename body_pose<Body>::vector_type& q)
      : now(q),
        own_end(now.template tip<Part>()),
        own_jacobian(now.template jacobian<Part>()),
        own_mass(mass_of<Body>::of(now)) {}
};
template <class Body, fixed_string Part>
struct tip_dynamics_at : parts_of_tip_dynamics<Body, Part>, tip_dynamics<Body, Part> {
  explicit tip_dynamics_at(const typename body_pose<Body>::vector_type& q)
      : parts_of_tip_dynamics<Body, Part>(q),
        tip_dynamics<Body, Part>(this->own_end, this->own_jacobian, this->own_mass) {}
  tip_dynamics_at(const tip_dynamics_at&) = delete;
  tip_dynamics_at& operator=(const tip_dynamics_at&) = delete;
};

}  // namespace cca::detail
