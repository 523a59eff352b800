// EXPECT: wire\.unknown_port: the wire `cgp\.phase` -> `gait\.phase` in walk names `cgp\.phase`, but there is no node `cgp`; did you mean `cpg\.phase`\?
// A wire names nodes that exist.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"cpg", oscillator>,
                         cca::node<"gait", gait>,
#if CCA_REJECT
                         cca::wire<"cgp.phase", "gait.phase">
#else
                         cca::wire<"cpg.phase", "gait.phase">
#endif
                         > {
};

cca::controller<walk> c;
