// EXPECT: latency\.exceeded: a sample of `stance\.angles` can be of any age when `recorder\.angles` is read, but walk requires at most 2: a clock on the way is
// Without a known clock on the way no age can be promised.
#include "parts.hpp"

struct now_and_then {
  auto process(cca::in<"angles", leg_angles> angles) -> cca::maybe<"angles", leg_angles> { return angles; }
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
#if CCA_REJECT
                         cca::node<"now_and_then", now_and_then>,
#else
                         cca::node<"now_and_then", posture>,
#endif
                         cca::node<"recorder", recorder>,
                         cca::wire<"stance.angles", "now_and_then.angles">,
                         cca::wire<"now_and_then.angles", "recorder.angles">,
                         cca::require<cca::latency<"stance.angles", "recorder.angles">, cca::beats<2>>> {
};

cca::controller<walk> c;
