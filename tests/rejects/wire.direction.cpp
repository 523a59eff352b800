// EXPECT: wire\.direction: a wire leads from an output to an input, but in `gait\.phase` -> `cpg\.phase` in walk `gait\.phase` is an input and `cpg\.phase` an
// A wire leads from an output to an input. Two inputs cannot be joined: wire the output that feeds one of
// them to the other too.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"cpg", oscillator>,
                         cca::node<"gait", gait>,
#if CCA_REJECT
                         cca::wire<"gait.phase", "cpg.phase">
#else
                         cca::wire<"cpg.phase", "gait.phase">
#endif
                         > {
};

cca::controller<walk> c;
