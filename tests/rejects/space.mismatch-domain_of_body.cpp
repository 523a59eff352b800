// EXPECT: space\.mismatch: the spaces of a body's dynamics are of joint angles, velocities, accelerations and torques
// The weight of an arm depends on where it is, not on how it moves.
#include "arm.hpp"

// Refused by a static_assert of the component, without a graph.

#if CCA_REJECT
cca::gravity_compensation<arm_body, velocities, torques> gravity;
#else
cca::gravity_compensation<arm_body, angles, torques> gravity;
#endif
