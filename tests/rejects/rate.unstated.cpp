// EXPECT: rate\.unstated: `stance\.angles` is published every beat but `recorder\.angles` is read every 10 beats, and the wire does not say what happens between
// Between two clocks a wire states what the reader gets: the newest sample, a queue or a delay. The same
// period with another phase is another clock.
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
