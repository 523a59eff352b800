// EXPECT: strategy\.misplaced: `gait` \(walking\) is a graph, which is cca::stoppable<> without a strategy: give the strategy to the nodes inside
// A graph stops and starts as a whole, but it does not fire; its components do.
#include "parts.hpp"

struct walking : cca::graph<cca::node<"cpg", oscillator>,
                            cca::node<"gait", gait>,
                            cca::wire<"cpg.phase", "gait.phase">> {};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::node<"gait", walking, cca::stoppable<cca::timed<10>>>
#else
                         cca::node<"gait", walking, cca::stoppable<>>
#endif
                         > {
};

cca::controller<walk> c;
