// A body of the engine: saves and restores its state (saved_body.hpp), its mass and its energy.
#pragma once

#include <cstring>

#include <ode/ode.h>

#include <cca/base/math/reductions.hpp>
#include <cca/base/eigen.hpp>
#include <cca/sim/robot/model/saved_body.hpp>

namespace cca::sim {

inline body_state save_body(dBodyID body) {
  body_state s;
  std::memcpy(s.position.data(), dBodyGetPosition(body), sizeof s.position);
  std::memcpy(s.quaternion.data(), dBodyGetQuaternion(body), sizeof s.quaternion);
  std::memcpy(s.rotation.data(), dBodyGetRotation(body), sizeof s.rotation);
  std::memcpy(s.velocity.data(), dBodyGetLinearVel(body), sizeof s.velocity);
  std::memcpy(s.angular_velocity.data(), dBodyGetAngularVel(body), sizeof s.angular_velocity);
  return s;
}

inline void restore_body(dBodyID body, const body_state& s) {
  dBodySetPosition(body, s.position[0], s.position[1],
                   s.position[2]);  // also tells the body's geometry that it moved
  // dBodySetQuaternion would normalise and change bits: write to the engine's own memory.
  std::memcpy(const_cast<dReal*>(dBodyGetQuaternion(body)), s.quaternion.data(), sizeof s.quaternion);
  std::memcpy(const_cast<dReal*>(dBodyGetRotation(body)), s.rotation.data(), sizeof s.rotation);
  dBodySetLinearVel(body, s.velocity[0], s.velocity[1], s.velocity[2]);
  dBodySetAngularVel(body, s.angular_velocity[0], s.angular_velocity[1], s.angular_velocity[2]);
  dBodySetForce(body, 0, 0, 0);
  dBodySetTorque(body, 0, 0, 0);
}

inline double mass_of(dBodyID body) {
  dMass m;
  dBodyGetMass(body, &m);
  return m.mass;
}

// Mass times position, kg m.
inline Eigen::Vector3d moment_of(dBodyID body) {
  return mass_of(body) * Eigen::Vector3d::Map(dBodyGetPosition(body));
}

inline double kinetic_energy(dBodyID body) {
  dMass m;
  dBodyGetMass(body, &m);
  const auto turn = Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(dBodyGetRotation(body));
  const Eigen::Vector3d v = Eigen::Vector3d::Map(dBodyGetLinearVel(body)),
                        w = turn.leftCols<3>().transpose() * Eigen::Vector3d::Map(dBodyGetAngularVel(body));
  const auto inertia = Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(m.I);
  return 0.5 * (m.mass * math::squared_norm(v) + math::dot(w, math::product(inertia.leftCols<3>(), w)));
}

inline double potential_energy(dBodyID body, double gravity) {
  return mass_of(body) * gravity * dBodyGetPosition(body)[2];
}

}  // namespace cca::sim
