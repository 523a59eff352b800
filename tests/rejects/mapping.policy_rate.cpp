// EXPECT: mapping\.policy_rate: the policy `walk` was trained at 50 Hz, and its output is of fast_targets \(joint_angles over knee, hip at 200 Hz\): give that space cca::rate<50>
// The rule `rate.mismatch` then compares the rate of the output with that of the node.
#include "policy_contract.hpp"

struct fast_targets : cca::space<cca::joint_angles, cca::axes<knee, hip>, cca::rate<200>> {};

#if CCA_REJECT
using commanded = fast_targets;
#else
using commanded = targets;
#endif
using walking = cca::imported_policy<walk::contract,
                                     cca::policy_inputs<cca::in<"gyro", rates>, cca::in<"joint_pos", angles>>,
                                     commanded>;

walking::parameters as_it_is;
