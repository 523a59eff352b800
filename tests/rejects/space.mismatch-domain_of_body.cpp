// EXPECT: space\.mismatch: velocities \(joint_velocities over .*\) stands where a space of joint_angles does
// The weight of an arm depends on where it is, not on how it moves.
#include "arm.hpp"

// Refused by a static_assert of the component, without a graph.

struct arm : cca::body<mount, cca::part<"arm", chain>> {};
struct torques : cca::space<cca::joint_torques, cca::axes<shoulder, elbow>> {};

#if CCA_REJECT
cca::gravity_compensation<arm, velocities, torques> gravity;
#else
cca::gravity_compensation<arm, angles, torques> gravity;
#endif
