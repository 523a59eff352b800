// EXPECT: component\.bad_result: the port `angles` is made from a vector of 3, and a sample of leg_angles \(joint_angles over hip, knee\) has 2 coordinates: give one number for each axis
// LINES: 18
// The same for an output that may stay empty.
#include "parts.hpp"

// Refused by a static_assert of the port's constructor, without a graph.

struct standing {
  auto process(cca::beat) -> cca::maybe<"angles", leg_angles> {
#if CCA_REJECT
    return Eigen::Vector3d(0.1, 0.2, 0.3);
#else
    return Eigen::Vector2d(0.1, 0.2);
#endif
  }
};
