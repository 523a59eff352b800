// EXPECT: space\.arithmetic: samples of this domain type have no such operator: calculate with their numbers
// LINES: 15
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
