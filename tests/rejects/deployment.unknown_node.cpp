// EXPECT: deployment\.unknown_node: environment `control` names `gaits`, but walk has no such node; did you mean `gait`\?
// An environment names components, or inner graphs, by their paths from the architecture, or from any mode of
// it.
#include "two_places.hpp"

struct split : cca::deployment<walk,
#if CCA_REJECT
                               cca::environment<"control", cca::nodes<"oscillator", "gaits">>,
#else
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
#endif
                               cca::environment<"log", cca::other_nodes>> {
};

cca::deployed<split> d;
