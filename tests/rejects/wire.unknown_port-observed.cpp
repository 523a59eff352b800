// EXPECT: wire\.unknown_port: cca::observe<`gpc\.\*`> in walk matches no output: write the path from the nodes of this graph on, as in
// An `observe` names outputs that exist.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"cpg", oscillator>,
#if CCA_REJECT
                         cca::observe<"gpc.*">
#else
                         cca::observe<"cpg.*">
#endif
                         > {
};

cca::controller<walk> c;
