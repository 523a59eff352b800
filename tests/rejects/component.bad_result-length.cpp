// EXPECT: component\.bad_result: the port `angles` is made from a vector of 3, and a sample of leg_angles \(joint_angles over hip, knee\) has 2 coordinates: give one number for each axis
// An output has one number for each axis of its space.
#include "parts.hpp"

// Refused by a static_assert of the port's constructor, without a graph.

struct crouch {
  auto process(cca::in<"angles", leg_angles>) -> cca::out<"angles", leg_angles> {
#if CCA_REJECT
    return Eigen::Vector3d(0.1, 0.5, -1.0);
#else
    return Eigen::Vector2d(0.5, -1.0);
#endif
  }
};
