// EXPECT: space\.wrong_length: a sample of leg_angles \(joint_angles over hip, knee\) has 2 coordinates and is made from a vector of 3: give one number for each axis
// LINES: 15
// A sample has as many numbers as its space has coordinates: one for each axis, of an orientation or a pose a
// quaternion.
#include "parts.hpp"

auto bent() {
#if CCA_REJECT
  return cca::sample<leg_angles>(Eigen::Vector3d(0.1, -0.5, 0.2));
#else
  return cca::sample<leg_angles>(Eigen::Vector2d(0.1, -0.5));
#endif
}
