// EXPECT: graph\.unknown_item: `walk` is no graph: a controller runs a struct derived from cca::graph<\.\.\.>; put a component into one as cca::node<`name`, walk>; if another error names walk, mend that first: a comma may be missing between two items of the graph, or a value
// ERRORS: 3
// Items are separated by commas. Here the compiler's own error comes first, at the line of the wire.
#include "parts.hpp"

// A type that is not there after the compiler's own error: no diagnosis sees this mistake, only the order of
// errors.

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"cpg", oscillator>,
                         cca::node<"gait", gait>,
                         cca::node<"record", recorder>,
#if CCA_REJECT
                         cca::wire<"cpg.phase", "gait.phase"> cca::wire<"gait.angles", "record.angles">
#else
                         cca::wire<"cpg.phase", "gait.phase">,
                         cca::wire<"gait.angles", "record.angles">
#endif
                         > {
};

cca::controller<walk> c;
