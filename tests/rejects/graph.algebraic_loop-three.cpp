// EXPECT: graph\.algebraic_loop: `a\.angles` -> `b\.angles`, `b\.angles` -> `c\.angles`, `c\.angles` -> `a\.angles` are a loop without delay, so none of their
// The message shows the whole loop.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"a", posture>,
                         cca::node<"b", posture>,
                         cca::node<"c", posture>,
                         cca::node<"recorder", recorder>,
                         cca::wire<"a.angles", "b.angles">,
                         cca::wire<"b.angles", "c.angles">,
                         cca::wire<"c.angles", "recorder.angles">,
#if CCA_REJECT
                         cca::wire<"c.angles", "a.angles">
#else
                         cca::wire<"c.angles", "a.angles", cca::delayed<1>>
#endif
                         > {
};

cca::controller<walk> c;
