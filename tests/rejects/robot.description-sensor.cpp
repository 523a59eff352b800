// EXPECT: robot\.description: the sensor `load` of pendulum is at the end of the part `hand`, which its body lacks: it has `arm`
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
