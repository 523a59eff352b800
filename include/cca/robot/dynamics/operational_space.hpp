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
// decomposition of the mass matrix, about n^2 products for each row; nothing allocates. For up to 128 numbers
// in mass matrix and rows together it is recorded (recorded/mobility.hpp), but for the inverse of rows x
// rows, which chooses its pivots as it goes; beyond, it is loops.
#pragma once

#include <cca/base/math/reductions.hpp>
#include <cca/base/math/positive_matrix.hpp>
#include <cca/robot/recorded/mobility.hpp>

namespace cca {
namespace detail {

template <int Rows, int Size>
void operational_space_by_loops(const Eigen::Matrix<double, Size, Size>& mass,
                                const Eigen::Matrix<double, Rows, Size>& rows,
                                Eigen::Matrix<double, Rows, Rows>& inertia,
                                Eigen::Matrix<double, Size, Rows>& inverse) {
  const positive_matrix<Size> m(mass);
  const Eigen::Matrix<double, Size, Rows> half =
      m.forward(Eigen::Matrix<double, Size, Rows>(rows.transpose()));
  inertia = generalised_inverse<Rows>(math::product(half.transpose(), half));
  inverse = m.backward(Eigen::Matrix<double, Size, Rows>(math::product(half, inertia)));
}

}  // namespace detail

template <int Rows, int Size>
struct operational_space {
  using vector = Eigen::Matrix<double, Size, 1>;

  Eigen::Matrix<double, Rows, Rows> inertia;
  Eigen::Matrix<double, Size, Rows> inverse;
  Eigen::Matrix<double, Rows, Size> jacobian;

  operational_space(const Eigen::Matrix<double, Size, Size>& mass,
                    const Eigen::Matrix<double, Rows, Size>& rows)
      : jacobian(rows) {
    using quantity = detail::recorded_mobility<Rows, Size>;
    if constexpr (detail::is_recorded<quantity>()) {
      Eigen::Matrix<double, Size, Rows> moved;
      detail::straight_line<quantity>::evaluate({moved.data(), inertia.data()}, mass.data(), rows.data());
      inertia = detail::generalised_inverse<Rows>(inertia);
      inverse = math::product(moved, inertia);
    } else {
      detail::operational_space_by_loops(mass, rows, inertia, inverse);
    }
  }

  vector free_motion(const vector& motion) const {
    return motion - math::product(inverse, math::product(jacobian, motion));
  }
  vector free_torques(const vector& torques) const {
    return torques - math::product(jacobian.transpose(), math::product(inverse.transpose(), torques));
  }
};

}  // namespace cca
