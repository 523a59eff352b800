// EXPECT: rate\.missing: neither walk nor any of its spaces states a rate, so a beat has no length: add cca::rate<1000> to the graph
// A beat has a length: from the graph's rate, or else from the fastest of its spaces. It is at least a
// nanosecond.
#include "parts.hpp"

struct walk : cca::graph<cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::node<"stance", stance>
#else
                         cca::rate<1000>,
                         cca::node<"stance", stance>
#endif
                         > {
};

cca::controller<walk> c;
