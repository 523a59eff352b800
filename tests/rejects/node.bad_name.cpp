// EXPECT: node\.bad_name: a node of walk is named `leg\.front`, but dots join names to paths, and `\*` stands for any name: use neither in a name
// Dots join names to paths. So nodes, ports, and the names under which a graph exposes ports have none, and
// none of these names is empty.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"cpg", oscillator>,
#if CCA_REJECT
                         cca::node<"leg.front", gait>,
                         cca::wire<"cpg.phase", "leg.front.phase">
#else
                         cca::node<"leg_front", gait>,
                         cca::wire<"cpg.phase", "leg_front.phase">
#endif
                         > {
};

cca::controller<walk> c;
