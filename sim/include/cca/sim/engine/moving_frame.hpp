// Where a frame is and how it moves, in the world.
#pragma once

#include <cca/mapping/kinematics.hpp>

namespace cca::sim {

// Velocities along the world's axes, of the frame's origin.
struct moving_frame {
  rigid where{};
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero(), velocity = Eigen::Vector3d::Zero();
};

inline double sum_of(const moving_frame& f) {
  return f.where.at.sum() + f.where.turn.sum() + f.velocity.sum() + f.angular_velocity.sum();
}

}  // namespace cca::sim
