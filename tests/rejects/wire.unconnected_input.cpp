// EXPECT: wire\.unconnected_input: `compare\.actual` is not connected: in walk, wire an output of leg_angles \(joint_angles over hip, knee\) to `compare\.actual`,
// An input needs a wire. What an inner graph exposes is wired outside, all else inside. Each mode of a set is
// checked as a graph by itself.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"compare", comparison>,
#if CCA_REJECT
                         cca::wire<"stance.angles", "compare.wanted">
#else
                         cca::wire<"stance.angles", "compare.wanted">,
                         cca::wire<"stance.angles", "compare.actual">
#endif
                         > {
};

cca::controller<walk> c;
