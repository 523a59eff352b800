// EXPECT: space\.arithmetic: samples of leg_angles \(joint_angles over hip, knee\) have no such operator \*: calculate with their numbers
// LINES: 18
// A matrix multiplies numbers, no samples.
#include "parts.hpp"

struct spring {
  auto process(cca::in<"at", leg_angles> at) -> cca::out<"torques", leg_torques> {
#if CCA_REJECT
    return -stiffness * at;
#else
    return -stiffness * at.vector();
#endif
  }
  Eigen::Matrix2d stiffness = Eigen::Matrix2d::Identity();
};
