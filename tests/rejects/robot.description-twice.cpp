// EXPECT: robot\.description: the joint `swing` of arm is in the groups `inner` and `outer`, which have the same kind of command
// `bend` would have two torques.
#include "pendulum.hpp"

struct arm : uncommanded<chain_of_two, 2> {
  using inner = cca::robots::of_joints<"inner", cca::robots::torque_command, torques_of<swing>>;
#if CCA_REJECT
  using outer = cca::robots::of_joints<"outer", cca::robots::torque_command, torques_of<bend, swing>>;
#else
  using outer = cca::robots::of_joints<"outer", cca::robots::torque_command, torques_of<bend>>;
#endif
  using commands = cca::robots::commands<inner, outer>;
};

static_assert(cca::robots::check_description<arm>());
