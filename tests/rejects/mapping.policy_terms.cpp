// EXPECT: mapping\.policy_terms: the policy `walk` observes `gyro` \(turning_in<trunk>\), and it has no port of this name: add a cca::in of it to the cca::policy_inputs
// Each observation of a policy is a port, and each port is an observation.
#include "policy_contract.hpp"

#if CCA_REJECT
using observations = cca::policy_inputs<cca::in<"joint_pos", angles>>;
#else
using observations = cca::policy_inputs<cca::in<"joint_pos", angles>, cca::in<"gyro", rates>>;
#endif
using walking = cca::imported_policy<walk::contract, observations, targets>;

walking::parameters as_it_is;
