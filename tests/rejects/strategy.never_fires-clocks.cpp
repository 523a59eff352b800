// EXPECT: strategy\.never_fires: `stance` \(stance\) never fires: the clocks under its cca::all_of have no beat in common; change a period or a phase
// Clocks under `all_of` need a beat in common.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::node<"stance", stance, cca::all_of<cca::timed<4, 1>, cca::timed<6, 2>>>
#else
                         cca::node<"stance", stance, cca::all_of<cca::timed<4, 1>, cca::timed<6, 3>>>
#endif
                         > {
};

cca::controller<walk> c;
