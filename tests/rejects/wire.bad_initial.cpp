// EXPECT: wire\.bad_initial: cca::initial of the wire `stance\.angles` -> `recorder\.angles` gives 3 numbers, but `recorder\.angles` has 2: give one for each, or
// An initial value has a number for each coordinate, or one for all. An input has one initial value, however
// many wires are merged there.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"recorder", recorder>,
#if CCA_REJECT
                         cca::wire<"stance.angles", "recorder.angles", cca::initial<0.1, 0.2, 0.3>>
#else
                         cca::wire<"stance.angles", "recorder.angles", cca::initial<0.1, -0.2>>
#endif
                         > {
};

cca::controller<walk> c;
