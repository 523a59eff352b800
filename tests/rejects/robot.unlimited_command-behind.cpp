// EXPECT: robot\.unlimited_command: `posture\.angles` reaches the actuator `leg\.command` without passing a limiter: put a cca::limiter<leg_angles> between them
// A component after the limiter may change the command and undo the limits.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"stance", stance>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::node<"posture", posture>,
                         cca::node<"leg", leg>,
#if CCA_REJECT
                         cca::wire<"stance.angles", "limits.command">,
                         cca::wire<"limits.safe", "posture.angles">,
                         cca::wire<"posture.angles", "leg.command">
#else
                         cca::wire<"stance.angles", "posture.angles">,
                         cca::wire<"posture.angles", "limits.command">,
                         cca::wire<"limits.safe", "leg.command">
#endif
                         > {
};

cca::controller<walk> c;
