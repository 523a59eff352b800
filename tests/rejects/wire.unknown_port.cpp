// EXPECT: wire\.unknown_port: the wire `cpg\.phase` -> `gait\.phsae` in walk names `gait\.phsae`, but `gait` \(gait\) has no such input; did you mean `gait\.phase`\?
// A wire names ports that exist, each with its node; the nearest one is offered, or those that the node has.
// So do cca::expose and the bound of a latency. Ports of an inner graph have the names under which it exposes
// them. An observer needs no wires.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"cpg", oscillator>,
                         cca::node<"gait", gait>,
#if CCA_REJECT
                         cca::wire<"cpg.phase", "gait.phsae">
#else
                         cca::wire<"cpg.phase", "gait.phase">
#endif
                         > {
};

cca::controller<walk> c;
