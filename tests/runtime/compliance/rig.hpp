// An arm of seven joints, its spaces, and what calls a component as the loop does.
#pragma once

#include <doctest/doctest.h>

#include <cca/robot/body_components.hpp>

#include "../../laws/compliance_laws.hpp"
#include "../body/bodies.hpp"

namespace compliance_test {

using body_test::arm, body_test::arm_base, body_test::flange, body_test::arm_axes;
using vector = Eigen::Matrix<double, 7, 1>;
using vector6 = Eigen::Matrix<double, 6, 1>;
using simulated = laws::simulated_arm<arm, "arm">;

// The torques in another order than the axes of the body.
struct angles : cca::space<cca::joint_angles, arm_axes> {};
struct velocities : cca::space<cca::joint_velocities, arm_axes> {};
struct torques : cca::space<cca::joint_torques,
                            cca::axes<body_test::a7,
                                      body_test::a6,
                                      body_test::a5,
                                      body_test::a4,
                                      body_test::a3,
                                      body_test::a2,
                                      body_test::a1>> {};
struct hand_pose : cca::space<cca::pose<arm_base>, cca::axes<cca::x, cca::y, cca::z>> {};

inline const vector bent{0.3, 0.5, -0.4, 1.1, 0.6, -0.7, 0.2};
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

// Inputs that have come, and are wired.
template <class Port, class Vector>
Port given(const Vector& v) {
  Port port(v, 0, true);
  if constexpr (requires { port.set_wired(); }) port.set_wired();
  return port;
}
inline auto angles_of(const vector& q) { return given<cca::in<"angles", angles>>(q); }
inline auto velocities_of(const vector& dq) { return given<cca::in<"velocities", velocities>>(dq); }
inline vector in_order(const vector& torques) { return torques.reverse(); }

template <class Enum, class Port>
bool is(const Port& port, Enum state) {
  return port.vector()[0] == cca::status_of(state);
}

}  // namespace compliance_test
