// EXPECT: deployment\.undelayed: `log` \(log_of<.*>\) observes `gait\.\*`: `gait\.angles` is published in environment `control` and read in environment `log`, so it takes at least a beat to get there: write cca::observe<`gait\.\*`, cca::delayed<1>>
// What a component observes in another environment is delayed too.
#include <cca/deployment.hpp>

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
                         cca::node<"log", log_of<cca::observe<"gait.*">>>
#else
                         cca::node<"log", log_of<cca::observe<"gait.*", cca::delayed<1>>>>
#endif
                         > {
};

struct split : cca::deployment<walk,
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
                               cca::environment<"log", cca::other_nodes>> {};

cca::deployed<split> d;
