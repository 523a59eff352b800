// EXPECT: strategy\.unknown_port: `gait` \(gait\) is cca::port_triggered by `phsae`, but it has no such input; did you mean `phase`\?
// A strategy that waits for inputs names inputs of its component, also within another strategy.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"cpg", oscillator>,
#if CCA_REJECT
                         cca::node<"gait", gait, cca::port_triggered<"phsae">>,
#else
                         cca::node<"gait", gait, cca::port_triggered<"phase">>,
#endif
                         cca::wire<"cpg.phase", "gait.phase">> {
};

cca::controller<walk> c;
