// EXPECT: deployment\.bad_environment: split has no environment: write cca::environment<`name`, cca::nodes<`a`, `b\.c`>> after the architecture, and one with cca::other_nodes
// A deployment has at least one environment.
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
                               cca::tolerate<2>
#else
                               cca::tolerate<2>,
                               cca::environment<"all", cca::other_nodes>
#endif
                               > {
};

cca::deployed<split> d;
