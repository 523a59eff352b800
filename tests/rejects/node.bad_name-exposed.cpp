// EXPECT: node\.bad_name: a port that walk exposes has no name, so no wire could name it: give it one
// The names under which a graph exposes ports obey the same rule.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"stance", stance>,
#if CCA_REJECT
                         cca::expose<"stance.angles", "">
#else
                         cca::expose<"stance.angles", "angles">
#endif
                         > {
};

cca::controller<walk> c;
