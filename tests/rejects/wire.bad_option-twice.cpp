// EXPECT: wire\.bad_option: the wire `stance\.angles` -> `recorder\.angles` has two policies or two initial values: leave one of
// A wire has one policy.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"recorder", recorder, cca::timed<10>>,
#if CCA_REJECT
                         cca::wire<"stance.angles", "recorder.angles", cca::latest, cca::delayed<2>>
#else
                         cca::wire<"stance.angles", "recorder.angles", cca::delayed<2>>
#endif
                         > {
};

cca::controller<walk> c;
