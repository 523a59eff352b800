// EXPECT: space\.unknown_axis: leg_angles \(joint_angles over hip, knee\) has no axis ankle: read or write one that it has
// A number of a sample is read by its axis, which is a type: a wrong one is seen by the compiler.
// LINES: 18
#include "parts.hpp"

struct ankle : cca::dimension<"ankle"> {};

double bent(const cca::sample<leg_angles>& q) {
#if CCA_REJECT
  return q[ankle{}];
#else
  return q[knee{}];
#endif
}
