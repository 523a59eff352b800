// EXPECT: space\.mismatch: the output `angles` of leg_angles \(joint_angles over hip, knee\) is made from a sample of leg_torques \(joint_torques over hip, knee\): the domain types differ; put a mapping between them
// LINES: 18
// An output takes samples of its own space only.
#include "parts.hpp"

// Refused by a static_assert of the port's constructor, without a graph.

struct spring {
  auto process(cca::in<"torques", leg_torques> torques) -> cca::out<"angles", leg_angles> {
#if CCA_REJECT
    return 0.1 * torques;
#else
    return 0.1 * torques.vector();
#endif
  }
};
