// EXPECT: deployment\.bad_environment: an environment of split is named `leg\.control`, but dots join names to paths, and `\*` stands for any name: use neither in a name
// The name of an environment is no path.
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
                               cca::environment<"leg.control", cca::nodes<"oscillator", "gait">>,
#else
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
#endif
                               cca::environment<"log", cca::other_nodes>> {
};

cca::deployed<split> d;
