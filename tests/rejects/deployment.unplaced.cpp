// EXPECT: deployment\.unplaced: `recorder` \(recorder\) runs in no environment of split: add its path to the cca::nodes<\.\.\.> of this environment, or give one cca::other_nodes
// Each component has an environment, in which it runs.
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
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>
#else
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
                               cca::environment<"log", cca::other_nodes>
#endif
                               > {
};

cca::deployed<split> d;
