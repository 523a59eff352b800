// EXPECT: deployment\.unknown_node: environment `control` names `gaits`, but walk has no such node; did you mean `gait`\?
// An environment names components, or inner graphs, by their paths from the architecture.
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
                               cca::environment<"control", cca::nodes<"oscillator", "gaits">>,
#else
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
#endif
                               cca::environment<"log", cca::other_nodes>> {
};

cca::deployed<split> d;
