// EXPECT: deployment\.bad_environment: environment `log` has `recorder` in place of its nodes: write cca::nodes<`a`, `b\.c`>, with the paths of components or inner graphs, or cca::other_nodes
// An environment names its nodes by their paths, not by their types.
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
                               cca::environment<"log", recorder>
#else
                               cca::environment<"log", cca::nodes<"recorder">>
#endif
                               > {
};

cca::deployed<split> d;
