// EXPECT: robot\.unlimited_command: `leg\.command` may be read before a first command has passed a limiter, and would then hold the cca::initial of its wire
// The limits also hold for what the actuator gets before the first command.
#include "parts.hpp"

struct walk
    : cca::graph<cca::rate<1000>,
                 cca::node<"log", logbook>,
                 cca::node<"stance", stance, cca::timed<10, 9>>,
                 cca::node<"limits", cca::limiter<leg_angles>>,
                 cca::node<"leg", leg>,
                 cca::wire<"stance.angles", "limits.command">,
#if CCA_REJECT
                 cca::wire<"limits.safe", "leg.command", cca::latest, cca::initial<0.2, 0.3>>  // the knee
                                                                                               // only flexes
#else
                 cca::wire<"limits.safe", "leg.command", cca::latest, cca::initial<0.2, -0.3>>
#endif
                 > {
};

cca::controller<walk> c;
