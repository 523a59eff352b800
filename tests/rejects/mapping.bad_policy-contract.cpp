// EXPECT: mapping\.bad_policy: the contract is that of a cca::imported_policy, a cca::policy or a stand-in, and this type is none
// Only what observes and commands has a contract; before there is a policy, a struct with `inputs` and
// `action_space` stands for it.
#include <cca/mapping/imported/policy_description.hpp>

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct angles : cca::space<cca::joint_angles, cca::axes<hip>> {};
struct learner {
  using inputs = cca::policy_inputs<cca::in<"angles", angles>>;
#if !CCA_REJECT
  using action_space = angles;
#endif
};

const auto described = cca::describe_policy<learner>();
