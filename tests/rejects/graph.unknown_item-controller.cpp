// EXPECT: graph\.unknown_item: `stance` is no graph: a controller runs a struct derived from cca::graph<\.\.\.>; put a component into one as cca::node<`name`, stance>
// A controller runs a graph, even if it has only one component.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"log", logbook>, cca::node<"stance", stance>> {};

#if CCA_REJECT
cca::controller<stance> c;
#else
cca::controller<walk> c;
#endif
