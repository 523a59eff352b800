// EXPECT: strategy\.never_fires: `stance` \(stance\) counts beats by a number below 1: in cca::timed<N> and cca::timeout<N> it is at least 1
// A number of beats is at least 1, in a combination too.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::node<"stance", stance, cca::any_of<cca::timed<4>, cca::timeout<0>>>
#else
                         cca::node<"stance", stance, cca::any_of<cca::timed<4>, cca::timeout<1>>>
#endif
                         > {
};

cca::controller<walk> c;
