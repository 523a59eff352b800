// EXPECT: node\.duplicate_name: two outputs are exposed as `angles` by walk: give one of them another name
// The ports that a graph exposes have different names too.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"left", stance>,
                         cca::node<"right", stance>,
                         cca::expose<"left.angles", "angles">,
#if CCA_REJECT
                         cca::expose<"right.angles", "angles">
#else
                         cca::expose<"right.angles", "right_angles">
#endif
                         > {
};

cca::controller<walk> c;
