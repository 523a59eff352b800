// EXPECT: deployment\.no_transport: the second argument of cca::deployed<split> is missing: write cca::shared_memory
// Where a process runs some of the environments, it says how it reaches the others.
#include "two_places.hpp"

struct split : cca::deployment<walk,
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
                               cca::environment<"log", cca::other_nodes>> {};

#if CCA_REJECT
cca::deployed<split> d(cca::only{"control"});
#else
cca::deployed<split> d(cca::only{"control"}, cca::shared_memory("/walk"));
#endif
