// EXPECT: rate\.mismatch: walk states two rates, 1000 Hz and 500 Hz, but all of it runs in one beat: keep one
// A graph has one rate.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::rate<500>,
#else
                         cca::rate<1e3>,
#endif
                         cca::node<"stance", stance>> {
};

cca::controller<walk> c;
