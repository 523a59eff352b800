// EXPECT: deployment\.bad_environment: split states cca::tolerate more than once: leave one of them
// A deployment has one cca::tolerate.
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
                               cca::tolerate<2>,
                               cca::tolerate<5>,
#else
                               cca::tolerate<2>,
#endif
                               cca::environment<"all", cca::other_nodes>> {
};

cca::deployed<split> d;
