// EXPECT: deployment\.undelayed: `gait\.angles` is published in environment `control` and read in environment `log`, so it takes at least a beat to get there: write cca::wire<`gait\.angles`, `recorder\.angles`, cca::delayed<1>>, or a greater delay
// A wire from one environment to another is delayed: these beats are the time to compute and to transport.
// Then a sample is in time wherever its reader runs, and the results are those of one loop.
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
