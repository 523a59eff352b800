// EXPECT: rate\.missing: `cca::rate<0>` is no rate, which is a number of updates per second above 0, as `cca::rate<1000>`; where none is meant, leave it out
// A rate is above 0.
#include "parts.hpp"

// Refused by a static_assert of cca::rate, before there is a graph.

struct walk : cca::graph<cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::rate<0>,
#else
                         cca::rate<1000>,
#endif
                         cca::node<"stance", stance>> {
};

cca::controller<walk> c;
