// EXPECT: strategy\.never_fires: `stance` \(stance\) has all_of<timed<2>, timed<2, 1>> in its strategy, which never fires: its clocks have no beat in common; change a period or a phase, or remove it
// The component would fire by the other strategy, but this part of it says nothing.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::node<"stance",
                                   stance,
                                   cca::any_of<cca::all_of<cca::timed<2>, cca::timed<2, 1>>, cca::timed<4>>>
#else
                         cca::node<"stance", stance, cca::any_of<cca::timed<2, 1>, cca::timed<4>>>
#endif
                         > {
};

cca::controller<walk> c;
