// EXPECT: robot\.description: the link that the joint `swing` of pendulum moves has no mass, so no torque could move it
// Kinematics need no inertia, but a simulated robot does, except between two hinges that cross.
#include "pendulum.hpp"

#if CCA_REJECT
struct pendulum : described<weightless_chain> {};
#else
struct pendulum : described<chain_of_one> {};
#endif

static_assert(cca::robots::check_description<pendulum>());
