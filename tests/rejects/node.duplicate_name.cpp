// EXPECT: node\.duplicate_name: two nodes of walk are named `gait` \(oscillator, gait\), so a path to them has two meanings: give one of them another name
// A path names one thing: the nodes of a graph and the ports that it exposes have different names.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"gait", oscillator>,
#if CCA_REJECT
                         cca::node<"gait", gait>,
                         cca::wire<"gait.phase", "gait.phase">
#else
                         cca::node<"shape", gait>,
                         cca::wire<"gait.phase", "shape.phase">
#endif
                         > {
};

cca::controller<walk> c;
