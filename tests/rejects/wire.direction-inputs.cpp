// EXPECT: wire\.direction: a wire leads from an output to an input, but in `compare\.actual` -> `compare\.wanted` in walk `compare\.actual` is an input: name an
// Two inputs cannot be joined: wire the output that feeds one of them to the other too.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"posture", posture>,
                         cca::node<"compare", comparison>,
                         cca::wire<"stance.angles", "posture.angles">,
                         cca::wire<"posture.angles", "compare.actual">,
#if CCA_REJECT
                         cca::wire<"compare.actual", "compare.wanted">
#else
                         cca::wire<"stance.angles", "compare.wanted">
#endif
                         > {
};

cca::controller<walk> c;
