// EXPECT: strategy\.coordination: `compare` \(comparison\) is cca::coordinated, but `compare\.wanted` \(from `wanted\.angles`, every 2 beats\) and `compare\.actual`
// A component that compares samples of one time needs sources that publish at one time.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"wanted", stance, cca::timed<2, 0>>,
#if CCA_REJECT
                         cca::node<"actual", stance, cca::timed<2, 1>>,
#else
                         cca::node<"actual", stance, cca::timed<2, 0>>,
#endif
                         cca::node<"compare", comparison, cca::coordinated>,
                         cca::wire<"wanted.angles", "compare.wanted">,
                         cca::wire<"actual.angles", "compare.actual">> {
};

cca::controller<walk> c;
