// EXPECT: deployment\.bad_environment: two environments of split are named `control`, so a message about one of them has two meanings: give one another name
// A deployment is of an architecture, and consists of environments; each has a name of its own and at least
// one component.
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
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
#else
                               cca::environment<"robot", cca::nodes<"oscillator", "gait">>,
#endif
                               cca::environment<"control", cca::other_nodes>> {
};

cca::deployed<split> d;
