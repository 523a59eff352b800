// EXPECT: body\.no_body: the body of a robot is wanted, and `chain` is a chain: write `cca::body<base, cca::part<name, chain>>`, or use what takes a chain, as cca::chain_pose
// LINES: 15
// A component of a body takes no chain, either.
#include <cca/cca.hpp>

#include "arm.hpp"

struct arm_body : cca::body<mount, cca::part<"arm", chain>> {};
struct torques : cca::space<cca::joint_torques, cca::axes<shoulder, elbow>> {};

#if CCA_REJECT
cca::gravity_compensation<chain, angles, torques> gravity;
#else
cca::gravity_compensation<arm_body, angles, torques> gravity;
#endif
