// EXPECT: mapping\.bad_policy: the policy that publishes angles \(joint_angles over hip\) has no inputs, so its network sees nothing
// What a network sees are ports, so each wire to it is checked.
#include <cca/mapping/policy.hpp>

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct angles : cca::space<cca::joint_angles, cca::axes<hip>> {};

#if CCA_REJECT
using observations = cca::policy_inputs<>;
#else
using observations = cca::policy_inputs<cca::in<"angles", angles>>;
#endif
using walk = cca::policy<observations, cca::hidden_layers<16>, cca::hyperbolic_tangent, angles>;

walk::parameters as_it_is;
