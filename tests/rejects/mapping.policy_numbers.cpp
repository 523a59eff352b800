// EXPECT: mapping\.policy_numbers: the policy `walk` observes the number hip of `joint_pos`, and other_angles \(joint_angles over knee, thigh\) has none of this name: numbers are matched by name
// Joints are matched by name, so another order costs nothing, and a joint that is missing is noticed.
#include "policy_contract.hpp"

struct thigh : cca::dimension<"thigh"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct other_angles : cca::space<cca::joint_angles, cca::axes<knee, thigh>> {};

#if CCA_REJECT
using wired = other_angles;
#else
using wired = angles;
#endif
using walking = cca::imported_policy<walk::contract,
                                     cca::policy_inputs<cca::in<"gyro", rates>, cca::in<"joint_pos", wired>>,
                                     targets>;

walking::parameters as_it_is;
