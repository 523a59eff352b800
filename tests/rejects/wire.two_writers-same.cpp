// EXPECT: wire\.two_writers: `recorder\.angles` is written by `stance\.angles` twice: remove one of the two wires
// One wire is enough.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"recorder", recorder>,
#if CCA_REJECT
                         cca::wire<"stance.angles", "recorder.angles">,
                         cca::wire<"stance.angles", "recorder.angles", cca::latest>
#else
                         cca::wire<"stance.angles", "recorder.angles">
#endif
                         > {
};

cca::controller<walk> c;
