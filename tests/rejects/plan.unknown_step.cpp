// EXPECT: plan\.unknown_step: the step `reach` of plan names `rset` in its cca::then, but the plan has no such step; did you mean `rest`\?
// A step leads to a step of the same plan, and each has a name of its own.
#include <cca/adaptive/sequencer.hpp>

#include "parts.hpp"

struct plan : cca::steps<cca::step<"rest">,
#if CCA_REJECT
                         cca::step<"reach", cca::after<100>, cca::then<"rset">>
#else
                         cca::step<"reach", cca::after<100>, cca::then<"rest">>
#endif
                         > {
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"plan", cca::sequencer<"stance.*", plan>>,
                         cca::node<"log", logbook>> {};

cca::controller<walk> c;
