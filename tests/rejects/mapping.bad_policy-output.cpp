// EXPECT: mapping\.bad_policy: the output of this policy, attitude \(orientation<[a-z]+> over x, y, z.*\), has more than one number per axis, as a pose has
// The numbers of a network are independent of each other; those of an orientation are not.
#include <cca/mapping/policy.hpp>

struct world : cca::frame<"world"> {};
struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct angles : cca::space<cca::joint_angles, cca::axes<hip>> {};
struct attitude : cca::space<cca::orientation<world>, cca::axes<cca::x, cca::y, cca::z>> {};

#if CCA_REJECT
using wanted = attitude;
#else
using wanted = angles;
#endif
using walk = cca::policy<cca::policy_inputs<cca::in<"angles", angles>>,
                         cca::hidden_layers<16>,
                         cca::hyperbolic_tangent,
                         wanted>;

walk::parameters as_it_is;
