// EXPECT: robot\.unlimited_command: `stance\.angles` reaches the actuator `leg\.command` without passing a limiter: put a cca::limiter<leg_angles> between them
// Every command passes a limiter before it reaches an actuator. A component after the limiter may undo the
// limits. They also hold for the cca::initial of each wire from the limiter on.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"stance", stance>,
                         cca::node<"leg", leg>,
#if CCA_REJECT
                         cca::wire<"stance.angles", "leg.command">
#else
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::wire<"stance.angles", "limits.command">,
                         cca::wire<"limits.safe", "leg.command">
#endif
                         > {
};

cca::controller<walk> c;
