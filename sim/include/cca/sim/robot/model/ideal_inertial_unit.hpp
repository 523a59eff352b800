// What an ideal inertial unit reads: without noise, bias or delay.
#pragma once

#include <Eigen/Core>

#include <cca/base/math/reductions.hpp>
#include <cca/robots/inertial.hpp>
#include <cca/sim/engine/moving_frame.hpp>

namespace cca::sim {

// After a beat (s) that began with the speed `before` (m/s, in the world); `gravity` in m/s^2.
inline robots::inertial_reading inertial_reading_of(const moving_frame& now,
                                                    const Eigen::Vector3d& before,
                                                    double beat,
                                                    double gravity) {
  const Eigen::Vector3d change = (now.velocity - before) / beat;
  const Eigen::Matrix3d into_unit = now.where.turn.transpose();
  robots::inertial_reading r;
  Eigen::Vector4d::Map(r.orientation.data()) = cca::detail::quaternion_of(now.where.turn);
  Eigen::Vector3d::Map(r.angular_velocity.data()) = math::product(into_unit, now.angular_velocity);
  Eigen::Vector3d::Map(r.specific_force.data()) =
      math::product(into_unit, change + Eigen::Vector3d(0, 0, gravity));
  return r;
}

}  // namespace cca::sim
