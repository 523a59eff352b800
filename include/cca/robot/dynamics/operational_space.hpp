// The dynamics of a body as its end feels them: operational-space inertia, and the joint motions and torques
// that the end does not feel.
//
//   const cca::body_pose<arm_body> now(q);
//   const cca::operational_space task(cca::mass_matrix(now), now.jacobian<"arm">());
//   task.inertia            6 x 6: wrench = inertia * acceleration of the end at rest; angular part first:
//                           kg m^2, kg m and kg, along the axes of the base
//   task.inverse            n x 6: from a motion of the end to the joint motion with the least kinetic energy
//                           (dynamically consistent generalised inverse)
//   task.free_motion(dq)    the part of a joint motion that does not move the end: (1 - inverse J) dq
//   task.free_torques(t)    the part of joint torques that does not accelerate it: (1 - J^T inverse^T) t
//
// Any rows of a Jacobian will do, for example the last three for the position. Directions in which the end
// can't move (a stretched arm; more rows than joints) have the inertia 0, so all results are finite; a
// direction counts as such if its mobility is below 1e-10 of what its row would have without the others.
// Near that the inertia is large, as in the real arm; where a direction begins or ends to count, the results
// jump.
// If the mass matrix or the rows are NaN or infinite, `inverse` and what uses it are not finite; `inertia` is
// finite and wrong, since such directions count as those in which the end can't move. No status says so:
// check the angles before (input_status.hpp). Source: Khatib, A unified approach for motion and force control
// of robot manipulators: The operational space formulation, IEEE J. Robotics and Automation 3(1), 1987: the
// kinetic energy matrix of the end, and for redundant arms the dynamically consistent inverse. Cost: a
// Cholesky decomposition of the mass matrix, about n^2 products for each row; nothing allocates.
#pragma once

#include <cca/robot/dynamics/positive_matrix.hpp>

namespace cca {

template <int Rows, int Size>
struct operational_space {
  using vector = Eigen::Matrix<double, Size, 1>;

  Eigen::Matrix<double, Rows, Rows> inertia;
  Eigen::Matrix<double, Size, Rows> inverse;
  Eigen::Matrix<double, Rows, Size> jacobian;

  operational_space(const Eigen::Matrix<double, Size, Size>& mass,
                    const Eigen::Matrix<double, Rows, Size>& rows)
      : jacobian(rows) {
    const detail::positive_matrix<Size> m(mass);
    const Eigen::Matrix<double, Size, Rows> half =
        m.forward(Eigen::Matrix<double, Size, Rows>(rows.transpose()));
    inertia = detail::generalised_inverse<Rows>(half.transpose() * half);
    inverse = m.backward(Eigen::Matrix<double, Size, Rows>(half * inertia));
  }

  vector free_motion(const vector& motion) const { return motion - inverse * (jacobian * motion); }
  vector free_torques(const vector& torques) const {
    return torques - jacobian.transpose() * (inverse.transpose() * torques);
  }
};

}  // namespace cca
