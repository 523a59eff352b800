// EXPECT: mapping\.policy_rest: the default position of knee in `joint_pos` of the policy `walk` is -0\.8 rad, and mirrored allows it from 0 to 1\.8: it may have another sign, zero or unit
// The default pose of a policy is within the limits of its robot, unless a joint counts the other way round.
#include "policy_contract.hpp"

namespace other {
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{0.0, 1.8}};
};
}  // namespace other
struct mirrored : cca::space<cca::joint_angles, cca::axes<other::knee, hip>> {};

#if CCA_REJECT
using wired = mirrored;
#else
using wired = angles;
#endif
using walking = cca::imported_policy<walk::contract,
                                     cca::policy_inputs<cca::in<"gyro", rates>, cca::in<"joint_pos", wired>>,
                                     targets>;

walking::parameters as_it_is;
