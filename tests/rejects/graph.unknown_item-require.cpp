// EXPECT: graph\.unknown_item: `require<latency<cpg\.phase, gait\.phase>, timed<2>>` in walk is no item of a graph, so it would be ignored: write
// Write an item in full.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"cpg", oscillator>,
                         cca::node<"gait", gait>,
                         cca::wire<"cpg.phase", "gait.phase">,
#if CCA_REJECT
                         cca::require<cca::latency<"cpg.phase", "gait.phase">, cca::timed<2>>
#else
                         cca::require<cca::latency<"cpg.phase", "gait.phase">, cca::beats<2>>
#endif
                         > {
};

cca::controller<walk> c;
