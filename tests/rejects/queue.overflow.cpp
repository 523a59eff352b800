// EXPECT: queue\.overflow: `stance\.angles` is published every beat but `recorder\.angles` is read every 10 beats, so the queue of 16 between them is full sooner
// A queue that fills faster than it is read overflows; state what is lost then. Where wires are merged, all
// of their samples fill one queue.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"recorder", recorder, cca::timed<10>>,
#if CCA_REJECT
                         cca::wire<"stance.angles", "recorder.angles", cca::queue<16, cca::reject>>
#else
                         cca::wire<"stance.angles", "recorder.angles", cca::queue<16, cca::drop_oldest>>
#endif
                         > {
};

cca::controller<walk> c;
