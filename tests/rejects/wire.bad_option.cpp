// EXPECT: wire\.bad_option: the wire `stance\.angles` -> `recorder\.angles` has the option `timed<10>`, which is no option of a wire: it may have a policy \(cca::latest,
// A wire has one policy and one initial value, and nothing else. A queue states what it loses when it is
// full.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"recorder", recorder, cca::timed<10>>,
#if CCA_REJECT
                         cca::wire<"stance.angles", "recorder.angles", cca::timed<10>>
#else
                         cca::wire<"stance.angles", "recorder.angles", cca::latest>
#endif
                         > {
};

cca::controller<walk> c;
