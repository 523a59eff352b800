// EXPECT: observe\.bad_policy: cca::observe<`gait\.\*`> of `log` \(log_of<.*>\) has `timed<10>`, which is no policy of an observer: write cca::latest, cca::delayed<N> or cca::queue<C, F>
// An observer has the policies of a wire. The strategy of its node says when it fires. What a graph observes
// for programs has these policies, too.
#include "parts.hpp"

template <class Heard>
struct log_of {
  void process(Heard) {}
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::wire<"oscillator.phase", "gait.phase">,
#if CCA_REJECT
                         cca::node<"log", log_of<cca::observe<"gait.*", cca::timed<10>>>>
#else
                         cca::node<"log", log_of<cca::observe<"gait.*">>, cca::timed<10>>
#endif
                         > {
};

cca::controller<walk> c;
