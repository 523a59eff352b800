// EXPECT: wire\.unknown_port: the wire `gait\.angles` -> `posture\.foot` in walk names `posture\.foot`, but `posture` \(posture\) has no such input; it has `angles`
// Where no name is near, the message lists those that the node has.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"cpg", oscillator>,
                         cca::node<"gait", gait>,
                         cca::node<"posture", posture>,
                         cca::wire<"cpg.phase", "gait.phase">,
#if CCA_REJECT
                         cca::wire<"gait.angles", "posture.foot">
#else
                         cca::wire<"gait.angles", "posture.angles", cca::queue<4>>
#endif
                         > {
};

cca::controller<walk> c;
// Nothing else is reported.
const auto lost = c.dropped() + c.dropped<"posture.angles">() + c.dropped("posture.angles");
