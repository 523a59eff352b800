// EXPECT: deployment\.bad_environment: two environments of split are named `control`, so a message about one of them has two meanings: give one another name
// A deployment is of an architecture, and consists of environments. Each has a name of its own without dots,
// and at least one component. It names its nodes in one cca::nodes<...>, or has cca::other_nodes. Beside the
// environments stands at most one cca::tolerate<N>: how many beats in a row a sample may come late. A
// deployment is neither deployed again nor a node of a graph; its architecture can be both.
#include "two_places.hpp"

struct split : cca::deployment<walk,
#if CCA_REJECT
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
#else
                               cca::environment<"robot", cca::nodes<"oscillator", "gait">>,
#endif
                               cca::environment<"control", cca::other_nodes>> {
};

cca::deployed<split> d;
