// EXPECT: component\.bad_result: the port `angles` is made from a vector of 3, and a sample of leg_angles \(joint_angles over hip, knee\) has 2 coordinates: give one number for each axis
// LINES: 18
// The same for an input that a test makes.
#include "parts.hpp"

// Refused by a static_assert of the port's constructor, without a graph.

#if CCA_REJECT
const cca::in<"angles", leg_angles> angles(Eigen::Vector3d(0.1, 0.2, 0.3), 0, true);
#else
const cca::in<"angles", leg_angles> angles(Eigen::Vector2d(0.1, 0.2), 0, true);
#endif
