// EXPECT: wire\.unknown_port: the wire `stance\.angles` -> `log\.angles` in walk names `log\.angles`, but `log` \(logbook\) has no such input: what it observes comes without a wire
// An observer needs no wires.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::wire<"stance.angles", "log.angles">,
#endif
                         cca::node<"stance", stance>> {
};

cca::controller<walk> c;
