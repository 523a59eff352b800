// EXPECT: deployment\.placed_twice: `gait` \(gait\) runs in environment `control` and in environment `log`: a component runs in one environment; remove it from one of the two
// A component runs in one environment: two would have two copies of it, each with a state of its own.
#include <cca/deployment.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::node<"recorder", recorder>,
                         cca::wire<"oscillator.phase", "gait.phase">,
                         cca::wire<"gait.angles", "recorder.angles", cca::delayed<1>>> {};

struct split : cca::deployment<walk,
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
#if CCA_REJECT
                               cca::environment<"log", cca::nodes<"gait", "recorder">>
#else
                               cca::environment<"log", cca::nodes<"recorder">>
#endif
                               > {
};

cca::deployed<split> d;
