// EXPECT: deployment\.bad_environment: environment `log` of split has no component, so it has nothing to run: the other environments name every node; remove a path there, or this environment
// An environment with cca::other_nodes has at least one component, too.
#include <cca/deployment.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::node<"recorder", recorder>,
                         cca::wire<"oscillator.phase", "gait.phase">,
                         cca::wire<"gait.angles", "recorder.angles", cca::delayed<1>>> {};

struct split : cca::deployment<walk,
#if CCA_REJECT
                               cca::environment<"control", cca::nodes<"oscillator", "gait", "recorder">>,
#else
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
#endif
                               cca::environment<"log", cca::other_nodes>> {
};

cca::deployed<split> d;
