// A link of a robot as a body of the engine: it lies in the link's centre of mass, along the link's axes.
#pragma once

#include <stdexcept>
#include <string>

#include <ode/ode.h>

#include <Eigen/Cholesky>

#include <cca/mapping/kinematics.hpp>
#include <cca/robot/dynamics/spatial_inertia.hpp>
#include <cca/sim/engine/moving_frame.hpp>

namespace cca::sim {

// How a body is turned in the world.
inline Eigen::Matrix3d turn_of(dBodyID b) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(dBodyGetRotation(b)).leftCols<3>();
}

// Throws std::invalid_argument for a mass or an inertia that no body can have.
inline dBodyID made_link(dWorldID world, const link_inertia& of, const std::string& name) {
  const auto& i = of.about_centre;
  dMass mass;
  dMassSetZero(&mass);
  const Eigen::Matrix3d inertia = cca::detail::matrix_of(i);
  if (!(of.mass > 0) || !inertia.allFinite() || !(inertia.llt().info() == Eigen::Success))
    throw std::invalid_argument("cca::sim::robot: " + name +
                                " needs a mass above 0 and an inertia that is positive definite");
  dMassSetParameters(&mass, of.mass, 0, 0, 0, i[0], i[1], i[2], i[3], i[4], i[5]);
  const dBodyID b = dBodyCreate(world);
  dBodySetMass(b, &mass);
  dBodySetGyroscopicMode(b, 0);  // gyroscopic.hpp
  return b;
}

inline void put_link(dBodyID b, const moving_frame& f, const link_inertia& of) {
  using vector = Eigen::Vector3d;
  const vector arm = f.where.turn * cca::detail::as_vector(of.centre), at = f.where.at + arm;
  const vector v = f.velocity + cca::detail::cross(f.angular_velocity, arm), &w = f.angular_velocity;
  const Eigen::Matrix3d& r = f.where.turn;
  const dMatrix3 rotation{r(0, 0), r(0, 1), r(0, 2), 0,       r(1, 0), r(1, 1),
                          r(1, 2), 0,       r(2, 0), r(2, 1), r(2, 2), 0};
  dBodySetRotation(b, rotation);
  dBodySetPosition(b, at[0], at[1], at[2]);
  dBodySetLinearVel(b, v[0], v[1], v[2]);
  dBodySetAngularVel(b, w[0], w[1], w[2]);
}

}  // namespace cca::sim
