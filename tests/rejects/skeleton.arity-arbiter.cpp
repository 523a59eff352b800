// EXPECT: skeleton\.arity: `arbiter` \(arbiter<.*>\) has 1 source, but between fewer than two there is nothing to choose or to mix: name two or more
// This arbiter has one writer.
#include "parts.hpp"

#if CCA_REJECT
using order = cca::by_priority<"swing">;
#else
using order = cca::by_priority<"reflex", "swing">;
#endif

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"swing", stance>,
                         cca::node<"recorder", recorder>,
                         cca::node<"arbiter", cca::arbiter<"angles", leg_angles, order>>,
                         cca::wire<"swing.angles", "arbiter.swing">,
#if !CCA_REJECT
                         cca::node<"reflex", stance>,
                         cca::wire<"reflex.angles", "arbiter.reflex">,
#endif
                         cca::wire<"arbiter.angles", "recorder.angles">> {
};

cca::controller<walk> c;
