// EXPECT: component\.bad_result: this vector has another number of coordinates than the space of the port has: give one number for each axis
// LINES: 15
// The same for an input that a test makes.
#include "parts.hpp"

// Refused by a static_assert of the port's constructor, without a graph.

#if CCA_REJECT
const cca::in<"angles", leg_angles> angles(Eigen::Vector3d(0.1, 0.2, 0.3), 0, true);
#else
const cca::in<"angles", leg_angles> angles(Eigen::Vector2d(0.1, 0.2), 0, true);
#endif
