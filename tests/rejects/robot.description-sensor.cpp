// EXPECT: robot\.description: a sensor is at the end of a part that the body doesn't have
// The body has no part `hand`: that is the frame in which its part `arm` ends.
#include "pendulum.hpp"

struct pendulum : described<> {
#if CCA_REJECT
  using sensors = cca::robots::sensors<cca::robots::force_sensor<"load", "hand">>;
#else
  using sensors = cca::robots::sensors<cca::robots::force_sensor<"load", "arm">>;
#endif
};

static_assert(cca::robots::check_description<pendulum>());
