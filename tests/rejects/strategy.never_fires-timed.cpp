// EXPECT: strategy\.never_fires: `stance` \(stance\) counts beats by a number below 1: in cca::timed<N> and cca::timeout<N> it is at least 1
// A clock cannot tick every 0 beats.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::node<"stance", stance, cca::timed<0>>
#else
                         cca::node<"stance", stance, cca::timed<1>>
#endif
                         > {
};

cca::controller<walk> c;
