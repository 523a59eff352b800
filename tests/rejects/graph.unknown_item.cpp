// EXPECT: graph\.unknown_item: `gait` in walk is no item of a graph, so it would be ignored: write cca::node<`name`, type> for a component or graph; the
// A graph consists of known items, each written in full; any other type would be ignored. A controller and a
// deployment take a graph, even if it has only one component.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"cpg", oscillator>,
#if CCA_REJECT
                         gait,
#else
                         cca::node<"gait", gait>,
#endif
                         cca::wire<"cpg.phase", "gait.phase">> {
};

cca::controller<walk> c;
