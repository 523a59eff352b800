// EXPECT: rate\.unstated: `stance\.angles` is published every beat but `recorder\.angles` is read every 10 beats, and the wire does not say what happens between
// Where two ends run at other beats, the wire says what that means: the newest sample, a queue, a delay.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"recorder", recorder, cca::timed<10>>,
#if CCA_REJECT
                         cca::wire<"stance.angles", "recorder.angles">
#else
                         cca::wire<"stance.angles", "recorder.angles", cca::latest>
#endif
                         > {
};

cca::controller<walk> c;
