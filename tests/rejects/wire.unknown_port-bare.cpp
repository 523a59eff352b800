// EXPECT: wire\.unknown_port: the wire `cpg` -> `gait\.phase` in walk names `cpg`, but a port is named with its node: `node\.port`
// A port is named with its node.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"cpg", oscillator>,
                         cca::node<"gait", gait>,
#if CCA_REJECT
                         cca::wire<"cpg", "gait.phase">
#else
                         cca::wire<"cpg.phase", "gait.phase">
#endif
                         > {
};

cca::controller<walk> c;
