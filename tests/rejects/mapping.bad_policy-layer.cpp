// EXPECT: mapping\.bad_policy: layer 2 of the network 1 - 16 - 0 - 1 \(inputs, layers, outputs\) has no units
// Nothing gets through a layer without units.
#include <cca/mapping/policy.hpp>

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct angles : cca::space<cca::joint_angles, cca::axes<hip>> {};

#if CCA_REJECT
using layers = cca::hidden_layers<16, 0>;
#else
using layers = cca::hidden_layers<16, 8>;
#endif
using walk =
    cca::policy<cca::policy_inputs<cca::in<"angles", angles>>, layers, cca::hyperbolic_tangent, angles>;

walk::network::output answer;
