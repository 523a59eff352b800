// What the controllers of the end of a part share: its pose, its Jacobian, its mobility, and the joint
// torques that it does not feel.
//
//   const cca::detail::tip_dynamics<Body, "arm"> tip(q);
//   tip.now, tip.end, tip.jacobian    body_pose, rigid, 6 x n
//   tip.mass                          mass matrix, n x n, and its decomposition `tip.solver`
//   tip.mobility                      J M^-1 J^T: acceleration of the end per wrench
//   tip.free_torques(t)               the part of joint torques that does not accelerate the end
//   tip.free_momentum(dq)             M times the part of a motion that does not move the end
//
// NaN and infinity make results that are not finite; nothing is kept. Precondition: each coordinate moves
// mass. Source: operational_space.hpp.
#pragma once

#include <cca/robot/compliance/compliance_spaces.hpp>
#include <cca/robot/dynamics/mass_matrix.hpp>
#include <cca/robot/dynamics/operational_space.hpp>

namespace cca::detail {

template <class Body, fixed_string Part>
struct tip_dynamics {
  static constexpr int size = body_pose<Body>::size;
  using vector = Eigen::Matrix<double, size, 1>;
  using matrix = Eigen::Matrix<double, size, size>;

  body_pose<Body> now;
  rigid end;
  Eigen::Matrix<double, 6, size> jacobian;
  matrix mass;
  positive_matrix<size> solver;
  matrix6 mobility, inertia;

  explicit tip_dynamics(const vector& q)
      : now(q),
        end(now.template tip<Part>()),
        jacobian(now.template jacobian<Part>()),
        mass(mass_matrix(now)),
        solver(mass) {
    const Eigen::Matrix<double, size, 6> half =
        solver.forward(Eigen::Matrix<double, size, 6>(jacobian.transpose()));
    mobility = half.transpose() * half;
    inertia = generalised_inverse<6>(mobility);
  }

  vector free_torques(const vector& t) const {
    return t - jacobian.transpose() * (inertia * (jacobian * solver.solve(t)));
  }
  vector free_momentum(const vector& dq) const {
    return mass * dq - jacobian.transpose() * (inertia * (jacobian * dq));
  }
};

}  // namespace cca::detail
