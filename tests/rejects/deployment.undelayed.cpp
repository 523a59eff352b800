// EXPECT: deployment\.undelayed: `gait\.angles` is published in environment `control` and read in environment `log`, so it takes at least a beat to get there: write cca::wire<`gait\.angles`, `recorder\.angles`, cca::delayed<1>>, or a greater delay
// A wire from one environment to another is delayed, inside of an inner graph and in each mode, too: these
// beats are the time to compute and to transport. Then a sample is in time wherever its reader runs, and the
// results are those of one loop. What a component observes elsewhere is delayed likewise. A queue is delayed,
// too: its samples enter it when they arrive, and what waits in it is not sent. An option of a skeleton sets
// the policies of the wires inside of it.
#include <cca/deployment.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::node<"recorder", recorder>,
                         cca::wire<"oscillator.phase", "gait.phase">,
#if CCA_REJECT
                         cca::wire<"gait.angles", "recorder.angles">
#else
                         cca::wire<"gait.angles", "recorder.angles", cca::delayed<1>>
#endif
                         > {
};

struct split : cca::deployment<walk,
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
                               cca::environment<"log", cca::other_nodes>> {};

cca::deployed<split> d;
