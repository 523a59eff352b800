// EXPECT: space\.arithmetic: samples of leg_angles \(joint_angles over hip, knee\) have no such operator -: calculate with their numbers, as in `to\.vector\(\) - at\.vector\(\)`
// LINES: 18
// Samples have the operations of their domain type. Angles have no sum; their numbers have.
#include "parts.hpp"

struct spring {
  auto process(cca::in<"to", leg_angles> to, cca::in<"at", leg_angles> at)
      -> cca::out<"torques", leg_torques> {
#if CCA_REJECT
    return 3.0 * (to - at);
#else
    return 3.0 * (to.vector() - at.vector());
#endif
  }
};
