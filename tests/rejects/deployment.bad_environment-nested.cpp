// EXPECT: deployment\.bad_environment: split is a deployment of the deployment first, whose environments would be ignored: deploy its architecture instead, walk
// A deployment is of an architecture, not of another deployment.
#include <cca/deployment.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::node<"recorder", recorder>,
                         cca::wire<"oscillator.phase", "gait.phase">,
                         cca::wire<"gait.angles", "recorder.angles", cca::delayed<1>>> {};

struct first : cca::deployment<walk,
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
                               cca::environment<"log", cca::other_nodes>> {};

struct split : cca::deployment<
#if CCA_REJECT
                   first,
#else
                   walk,
#endif
                   cca::environment<"robot", cca::other_nodes>> {
};

cca::deployed<split> d;
