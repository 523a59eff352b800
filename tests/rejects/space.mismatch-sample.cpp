// EXPECT: space\.mismatch: this sample is of another space than the output: their domain types or axes differ; put a mapping between them
// LINES: 15
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
