// EXPECT: strategy\.misplaced: `gait` \(walking\) is a graph, and a strategy stands on components: give it to the nodes inside
// A graph does not fire; its components do.
#include "parts.hpp"

struct walking : cca::graph<cca::node<"cpg", oscillator>,
                            cca::node<"gait", gait>,
                            cca::wire<"cpg.phase", "gait.phase">> {};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::node<"gait", walking, cca::timed<10>>
#else
                         cca::node<"gait", walking>
#endif
                         > {
};

cca::controller<walk> c;
