// EXPECT: wire\.bad_initial: `recorder\.angles` gets an initial value from two of the wires that are merged there, and they differ: leave the cca::initial of one
// An input has one initial value, however many wires are merged there.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance, cca::timed<2>>,
                         cca::node<"swing", stance, cca::timed<2>>,
                         cca::node<"recorder", recorder>,
                         cca::wire<"stance.angles", "recorder.angles", cca::merged<8>, cca::initial<0.1>>,
#if CCA_REJECT
                         cca::wire<"swing.angles", "recorder.angles", cca::merged<8>, cca::initial<0.2>>
#else
                         cca::wire<"swing.angles", "recorder.angles", cca::merged<8>>
#endif
                         > {
};

cca::controller<walk> c;
