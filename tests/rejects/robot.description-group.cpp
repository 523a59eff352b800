// EXPECT: robot\.description: the port `outer` of arm is over the axis wave, which its body lacks; take it out
// The body has no joint `wave`.
#include "pendulum.hpp"

struct arm : described<chain_of_two, 2> {
#if CCA_REJECT
  using readings = cca::robots::readings<cca::robots::torques_of<"outer", torques_of<bend, wave>>>;
#else
  using readings = cca::robots::readings<cca::robots::torques_of<"outer", torques_of<bend>>>;
#endif
};

static_assert(cca::robots::check_description<arm>());
