// EXPECT: queue\.overflow: `recorder\.angles` is read every beat, but samples come from `stance\.angles` \(published every beat\) and from `swing\.angles` \(published every beat\), so the queue of 16 is full sooner
// Where wires are merged, all of their samples fill one queue.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"swing", stance>,
                         cca::node<"recorder", recorder, cca::timed<1>>,
#if CCA_REJECT
                         cca::wire<"stance.angles", "recorder.angles", cca::merged<16, cca::reject>>,
                         cca::wire<"swing.angles", "recorder.angles", cca::merged<16, cca::reject>>
#else
                         cca::wire<"stance.angles", "recorder.angles", cca::merged<16, cca::drop_newest>>,
                         cca::wire<"swing.angles", "recorder.angles", cca::merged<16, cca::drop_newest>>
#endif
                         > {
};

cca::controller<walk> c;
