// EXPECT: graph\.algebraic_loop: `memory\.angles` -> `memory\.angles` is a loop without delay, so its component would have to come before itself; say where it may
// A component that reads its own output reads what it published before.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"memory", posture>,
#if CCA_REJECT
                         cca::wire<"memory.angles", "memory.angles">
#else
                         cca::wire<"memory.angles", "memory.angles", cca::delayed<1>>
#endif
                         > {
};

cca::controller<walk> c;
