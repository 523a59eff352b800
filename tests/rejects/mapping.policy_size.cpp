// EXPECT: mapping\.policy_size: the network of the policy `walk` has 5 inputs and 2 outputs, and its contract 10 and 2: the header was changed; import again
// A header that cca-policy wrote is never changed by hand.
#include "policy_contract.hpp"

#if CCA_REJECT
struct written : walk::contract {
  static constexpr int history = 2;
};
#else
using written = walk::contract;
#endif
using walking = cca::imported_policy<written,
                                     cca::policy_inputs<cca::in<"gyro", rates>, cca::in<"joint_pos", angles>>,
                                     targets>;

walking::parameters as_it_is;
