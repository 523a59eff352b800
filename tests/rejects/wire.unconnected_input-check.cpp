// EXPECT: wire\.unconnected_input: `limits\.command` is not connected: in walk, wire an output of leg_angles
// LINES: 15
// cca::check says it where the graph is written; the controller does not repeat it.
#include "parts.hpp"

// A diagnosis does not tell how often the compiler says it.

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::node<"leg", leg>,
                         cca::node<"log", logbook>,
#if !CCA_REJECT
                         cca::wire<"stance.angles", "limits.command">,
#endif
                         cca::wire<"limits.safe", "leg.command">> {
};

static_assert(cca::check<walk>());

cca::controller<walk> c;
