// EXPECT: observe\.nothing: `watchdog\.watch` .*observes `leg\.angels`, which names nothing in .* or in a graph around it, so it would hear nothing; did you mean `leg\.angles`\?
// A watchdog of one source observes it, so it names one that exists.
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
