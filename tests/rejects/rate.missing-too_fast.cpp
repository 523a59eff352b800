// EXPECT: rate\.missing: walk or one of its spaces states 2000000000 Hz, and a beat is at least a nanosecond long: state at most 1,000,000,000 Hz
// A beat is at least a nanosecond long.
#include "parts.hpp"

struct walk : cca::graph<cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::rate<2'000'000'000>,
#else
                         cca::rate<1'000'000'000>,
#endif
                         cca::node<"stance", stance>> {
};

cca::controller<walk> c;
