// The robot: what described.hpp says, which cca-urdf wrote from @urdf@. When that file changes, write it
// again:
//
//   cca-urdf @urdf@@options@ --namespace my_robot::urdf --out described.hpp
//
// Keep your own things here: a servo, sensors, a starting posture (cca's docs/urdf.md).
#pragma once

#include <cstddef>

#include <cca/cca.hpp>
#include <cca/robots/ports.hpp>

#include "described.hpp"

namespace my_robot {

struct description : urdf::description {
  static constexpr bool floats = false;  // its base is held, as on a test stand
};

using body = description::body;
using angles = cca::robots::angles<description>;          // rad; of a prismatic joint m
using velocities = cca::robots::velocities<description>;  // rad/s, m/s
using torques = cca::robots::torques<description>;        // N m, N

constexpr bool has_motor(Eigen::Index joint) {
  return description::drives[static_cast<std::size_t>(joint)].motor.torque > 0;
}

// Where it starts: 0, unless the description says something else.
template <class Robot = description>
angles::vector_type start() {
  if constexpr (requires { Robot::start; }) return angles::vector_type::Map(Robot::start.data());
  else return angles::vector_type::Zero();
}

}  // namespace my_robot
