// EXPECT: wire\.unknown_port: `watchdog\.watch` .*names `leg\.angels`, but neither its graph nor one around it has such an output
// A watchdog of one source names an output that exists.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
#if CCA_REJECT
                         cca::node<"watchdog", cca::watchdog<leg_angles, 5, cca::of<"leg.angels">>>,
#else
                         cca::node<"watchdog", cca::watchdog<leg_angles, 5, cca::of<"leg.angles">>>,
#endif
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::node<"leg", leg>,
                         cca::wire<"stance.angles", "watchdog.command">,
                         cca::wire<"watchdog.fresh", "limits.command">,
                         cca::wire<"limits.safe", "leg.command">> {
};

cca::controller<walk> c;
