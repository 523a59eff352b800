// EXPECT: strategy\.unknown_port: `gait` \(gait\) is cca::port_triggered by `angles`, but it has no such input; did you mean `phase`\?
// Strategies within others are checked too.
#include "parts.hpp"

struct walk
    : cca::graph<cca::rate<1000>,
                 cca::node<"log", logbook>,
                 cca::node<"cpg", oscillator>,
#if CCA_REJECT
                 cca::node<"gait", gait, cca::any_of<cca::timeout<15>, cca::port_triggered<"angles">>>,
#else
                 cca::node<"gait", gait, cca::any_of<cca::timeout<15>, cca::port_triggered<"phase">>>,
#endif
                 cca::wire<"cpg.phase", "gait.phase">> {
};

cca::controller<walk> c;
