// EXPECT: wire\.unknown_port: cca::latency<`cpg\.phase`, `gait\.angles`> in walk names `gait\.angles`, but `gait` \(gait\) has no such input
// A bound names ports that exist.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"cpg", oscillator>,
                         cca::node<"gait", gait>,
                         cca::wire<"cpg.phase", "gait.phase">,
#if CCA_REJECT
                         cca::require<cca::latency<"cpg.phase", "gait.angles">, cca::beats<2>>
#else
                         cca::require<cca::latency<"cpg.phase", "gait.phase">, cca::beats<2>>
#endif
                         > {
};

cca::controller<walk> c;
