// EXPECT: wire\.two_writers: `recorder\.angles` is written by `stance\.angles` and by `swing\.angles`, one by cca::merged<8, cca::drop_oldest> and one by cca::merged<4, cca::drop_oldest>, but wires that are merged at an input lead into one queue: give each of them the same cca::merged<C, F>
// Wires that are merged at an input lead into one queue, so they state the same one.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance, cca::timed<2>>,
                         cca::node<"swing", stance, cca::timed<2>>,
                         cca::node<"recorder", recorder>,
#if CCA_REJECT
                         cca::wire<"stance.angles", "recorder.angles", cca::merged<8>>,
                         cca::wire<"swing.angles", "recorder.angles", cca::merged<4>>
#else
                         cca::wire<"stance.angles", "recorder.angles", cca::merged<8>>,
                         cca::wire<"swing.angles", "recorder.angles", cca::merged<8>>
#endif
                         > {
};

cca::controller<walk> c;
