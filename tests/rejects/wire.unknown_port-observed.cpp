// EXPECT: wire\.unknown_port: cca::observe<`gpc\.\*`> in walk hears nothing, for no output has such a path: write it from the nodes of this graph on, as in
// What is listened to from outside exists.
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
