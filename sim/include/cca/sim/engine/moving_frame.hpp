// Where a frame is and how it moves, in the world.
#pragma once

#include <cca/base/math/reductions.hpp>
#include <cca/mapping/kinematics.hpp>

namespace cca::sim {

// Velocities along the world's axes, of the frame's origin.
struct moving_frame {
  rigid where{};
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero(), velocity = Eigen::Vector3d::Zero();
};

inline double sum_of(const moving_frame& f) {
  return math::sum(f.where.at) + math::sum(f.where.turn) + math::sum(f.velocity) +
         math::sum(f.angular_velocity);
}

}  // namespace cca::sim
