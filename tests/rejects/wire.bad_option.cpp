// EXPECT: wire\.bad_option: the wire `stance\.angles` -> `recorder\.angles` has the option `timed<10>`, which is no option of a wire: it may have a policy \(cca::latest,
// A wire has a policy and an initial value, and nothing else.
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
