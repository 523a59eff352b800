// EXPECT: robot\.unlimited_command: `test_leg_command\.output` reaches the actuator `leg\.command` without passing a limiter
// A test adds to what an input gets, so a limiter must come after it: test what goes into the limiter.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"stance", stance>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::node<"leg", leg>,
                         cca::wire<"stance.angles", "limits.command">,
                         cca::wire<"limits.safe", "leg.command">,
#if CCA_REJECT
                         cca::test_input<"leg.command">
#else
                         cca::test_input<"limits.command">
#endif
                         > {
};

cca::controller<walk> c;
