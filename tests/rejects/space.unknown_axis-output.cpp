// EXPECT: space\.unknown_axis: leg_angles \(joint_angles over hip, knee\) has no axis ankle: read or write one that it has
// The same of an output that is filled by axis.
#include "parts.hpp"

struct ankle : cca::dimension<"ankle"> {};

struct crouch {
  auto process(cca::beat) -> cca::out<"angles", leg_angles> {
    cca::out<"angles", leg_angles> q;
#if CCA_REJECT
    q[ankle{}] = 0.5;
#else
    q[knee{}] = -0.5;
#endif
    return q;
  }
};
