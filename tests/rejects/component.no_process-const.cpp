// EXPECT: component\.no_process: `stance` \(const stance\) is const, but a component changes as it runs: remove the `const`
// A component is not const: its parameters are loaded, its state changes, and a snapshot is assigned to it.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::node<"stance", const stance>
#else
                         cca::node<"stance", stance>
#endif
                         > {
};

void beat(cca::controller<walk>& c) { c.step(); }
