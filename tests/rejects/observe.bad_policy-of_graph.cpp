// EXPECT: observe\.bad_policy: cca::observe<`gait\.\*`> in walk has a policy, but the program reads the newest samples, between two beats: leave it out
// What a graph observes for programs has no policy: the newest samples are read.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::wire<"oscillator.phase", "gait.phase">,
#if CCA_REJECT
                         cca::observe<"gait.*", cca::delayed<1>>
#else
                         cca::observe<"gait.*">
#endif
                         > {
};

cca::controller<walk> c;
