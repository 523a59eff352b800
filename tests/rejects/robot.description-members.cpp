// EXPECT: robot\.description: pendulum lacks `commands`: the description of a robot states `body`
// What a robot takes are its ports, so a description says it, even if it takes nothing.
#include "pendulum.hpp"

struct pendulum : uncommanded<chain_of_one, 1> {
#if !CCA_REJECT
  using commands = cca::robots::commands<cca::robots::torque_command>;
#endif
};

static_assert(cca::robots::check_description<pendulum>());
