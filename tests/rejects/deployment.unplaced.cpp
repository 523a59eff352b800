// EXPECT: deployment\.unplaced: `recorder` \(recorder\) runs in no environment of split: add its path to the cca::nodes<\.\.\.> of this environment, or give one cca::other_nodes
// Each component, of each mode, has an environment, in which it runs.
#include "two_places.hpp"

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
