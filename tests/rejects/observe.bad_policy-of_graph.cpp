// EXPECT: observe\.bad_policy: cca::observe<`gait\.\*`> in walk is cca::merged, but what it hears may be of several spaces, and each has a queue of its own: write cca::latest, cca::delayed<N> or cca::queue<C, F>
// What a graph observes for programs has the policies of an observer.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::wire<"oscillator.phase", "gait.phase">,
#if CCA_REJECT
                         cca::observe<"gait.*", cca::merged<4>>
#else
                         cca::observe<"gait.*", cca::queue<4>>
#endif
                         > {
};

cca::controller<walk> c;
