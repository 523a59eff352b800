// EXPECT: latency\.exceeded: a sample of `leg\.angles` can be 3 beats old when `leg\.command` is read, but walk requires at most 2: shorten a delay or a queue on
// A graph can require that a sample is not too old when it is read. Without a known clock on the way no age
// can be promised.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"leg", leg>,
                         cca::node<"posture", posture>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
#if CCA_REJECT
                         cca::wire<"leg.angles", "posture.angles", cca::delayed<3>>,
#else
                         cca::wire<"leg.angles", "posture.angles", cca::delayed<2>>,
#endif
                         cca::wire<"posture.angles", "limits.command">,
                         cca::wire<"limits.safe", "leg.command">,
                         cca::require<cca::latency<"leg.angles", "leg.command">, cca::beats<2>>> {
};

cca::controller<walk> c;
