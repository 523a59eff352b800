// The equations of a discrete movement primitive of a pose: position and orientation on one phase.
//
//   position      tau z' = az (az / 4 (g - p) - z) + x (w psi) (g - p0),              tau p' = z
//   orientation   tau e' = az (az / 4 log(gq q^-1) - e) + x (w psi) log(gq q0^-1),    tau q' = e q / 2
//   phase         tau x' = -ax x, from 1, for both
//   goals         tau g' = ag (goal - g),  tau gq' = ag log(goal gq^-1) gq / 2
//
// log is the rotation vector of a quaternion (twice the quaternion logarithm of the source), along the axes
// of the frame; e / tau is the angular velocity in it; vectors are multiplied by component. Rotations go the
// shorter way. state: p, z, q, e, g, gq, x; quaternions as x, y, z, w. input: goal pose (7), pose where the
// movement began (7), tau in s. Closed form without forcing term, from rest: the remaining angle about a
// fixed axis falls as (1 + l t) e^(-l t), l = az / (2 tau), like the distance.
// Source: Ude, Nemec, Petric, Morimoto, Orientation in Cartesian space dynamic movement primitives, ICRA 2014
// (its quaternion form); position and phase: Ijspeert et al., Neural Computation 25, 2013. Checked against
// the closed form (tests/runtime/motor/dmp_pose.cpp).
#pragma once

#include <algorithm>

#include <cca/base/math/reductions.hpp>
#include <cca/adaptive/ode.hpp>
#include <cca/motor/equations/dmp_basis.hpp>
#include <cca/space/methods/rotation.hpp>

namespace cca {

template <int N>
struct dmp_pose_ode {
  using vector3 = Eigen::Matrix<double, 3, 1>;
  using vector4 = Eigen::Matrix<double, 4, 1>;
  using pose = Eigen::Matrix<double, 7, 1>;  // position, quaternion
  using state = Eigen::Matrix<double, 21, 1>;
  using input = Eigen::Matrix<double, 15, 1>;
  struct parameters {
    Eigen::Matrix<double, 6, N> weights;  // three rows for the position, three for the rotation
    double stiffness;                     // az
    double decay;                         // ax
    double goal_rate;                     // ag
    bool scaled;                          // the forcing term is scaled by the way from start to goal
  };

  static state initial() {
    pose zero;
    zero << 0, 0, 0, 0, 0, 0, 1;
    return at_rest(zero, zero);
  }
  static state at_rest(const pose& at, const pose& goal) {
    state s;
    s << at.template head<3>(), vector3::Zero(), at.template tail<4>(), vector3::Zero(), goal, 1.0;
    return project(s);
  }
  static state project(state s) {
    s.template segment<4>(6) = rotation::normalised(vector4(s.template segment<4>(6)));
    s.template segment<4>(16) = rotation::normalised(vector4(s.template segment<4>(16)));
    return s;
  }

  // The rotation vector from one orientation to another, by the shorter way.
  static vector3 turn(const vector4& from, const vector4& to) {
    return rotation::log(rotation::product(to, rotation::inverse(from)));
  }
  // From one pose to another: the difference of the positions, then the rotation vector.
  static Eigen::Matrix<double, 6, 1> way(const pose& from, const pose& to) {
    Eigen::Matrix<double, 6, 1> all;
    all << to.template head<3>() - from.template head<3>(),
        turn(from.template tail<4>(), to.template tail<4>());
    return all;
  }
  static vector4 turning(const vector3& angular, const vector4& q) {
    return 0.5 * rotation::product(vector4(angular[0], angular[1], angular[2], 0), q);
  }

  // The transformation system has a double eigenvalue -az / 2.
  static double fastest(const state&, const input& u, const parameters& p) {
    return std::max({p.stiffness / 2, p.goal_rate, p.decay}) / u[14];
  }

  static state derivative(const state& s, const input& u, const parameters& p) {
    const vector3 at = s.template head<3>(), z = s.template segment<3>(3), e = s.template segment<3>(10),
                  g = s.template segment<3>(13);
    const vector4 q = s.template segment<4>(6), gq = s.template segment<4>(16);
    const Eigen::Matrix<double, 6, 1> shape =
        s[20] * math::product(p.weights, discrete_activations<N>(s[20], p.decay));
    vector3 way = vector3::Ones(), turn_of_it = vector3::Ones();
    if (p.scaled) {
      way = g - u.template segment<3>(7);
      turn_of_it = turn(u.template segment<4>(10), gq);
    }
    state rate;
    rate.template head<3>() = z;
    rate.template segment<3>(3) =
        p.stiffness * (p.stiffness / 4 * (g - at) - z) + shape.template head<3>().cwiseProduct(way);
    rate.template segment<4>(6) = turning(e, q);
    rate.template segment<3>(10) =
        p.stiffness * (p.stiffness / 4 * turn(q, gq) - e) + shape.template tail<3>().cwiseProduct(turn_of_it);
    rate.template segment<3>(13) = p.goal_rate * (u.template head<3>() - g);
    rate.template segment<4>(16) = turning(p.goal_rate * turn(gq, u.template segment<4>(3)), gq);
    rate[20] = -p.decay * s[20];
    return rate / u[14];
  }
};

}  // namespace cca
