// EXPECT: observe\.queue: cca::observe<`gait\.\*\*`> in walk names the input `gait\.phase` later than it is read, but that has a queue, and what waits in a queue is gone once it was read: observe the outputs alone, with `gait\.\*\*\.\*`
// The same for what a graph observes for programs: of its outputs a queue or a delay is one of its own.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait, cca::timed<1>>,
                         cca::wire<"oscillator.phase", "gait.phase", cca::queue<4, cca::drop_oldest>>,
#if CCA_REJECT
                         cca::observe<"gait.**", cca::delayed<1>>
#else
                         cca::observe<"gait.**.*", cca::delayed<1>>
#endif
                         > {
};

cca::controller<walk> c;
