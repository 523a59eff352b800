// EXPECT: wire\.bad_option: the wire `stance\.angles` -> `recorder\.angles` has a queue with `latest`, which does not say what a full queue loses: write cca::drop_oldest, cca::drop_newest or
// A queue states what it loses when it is full.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"recorder", recorder, cca::timed<10>>,
#if CCA_REJECT
                         cca::wire<"stance.angles", "recorder.angles", cca::queue<8, cca::latest>>
#else
                         cca::wire<"stance.angles", "recorder.angles", cca::queue<8, cca::drop_oldest>>
#endif
                         > {
};

cca::controller<walk> c;
