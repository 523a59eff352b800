// EXPECT: rate\.unstated: `stance\.angles` is published every 2 beats from beat 1 but `recorder\.angles` is read every 2 beats, and the wire does not say what
// The same period with another phase is another clock.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance, cca::timed<2, 1>>,
                         cca::node<"recorder", recorder, cca::timed<2>>,
#if CCA_REJECT
                         cca::wire<"stance.angles", "recorder.angles">
#else
                         cca::wire<"stance.angles", "recorder.angles", cca::latest>
#endif
                         > {
};

cca::controller<walk> c;
