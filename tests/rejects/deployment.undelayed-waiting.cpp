// EXPECT: deployment\.undelayed: `log` \(log_of<.*>\) observes `gait\.phase\.\*\*`, and so the input `gait\.phase` in environment `control`, but what waits in its queue now is known only there: write cca::observe<`gait\.phase\.\*\*`, cca::delayed<1>>
// What waits in a queue is not sent. With a delay, an observer elsewhere hears what is taken from it.
#include <cca/deployment.hpp>

#include "parts.hpp"

template <class Heard>
struct log_of {
  void process(Heard) {}
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait, cca::timed<1>>,
                         cca::wire<"oscillator.phase", "gait.phase", cca::delayed<1>, cca::queue<4>>,
#if CCA_REJECT
                         cca::node<"log", log_of<cca::observe<"gait.phase.**">>>
#else
                         cca::node<"log", log_of<cca::observe<"gait.phase.**", cca::delayed<1>>>>
#endif
                         > {
};

struct split : cca::deployment<walk,
                               cca::environment<"control", cca::nodes<"gait">>,
                               cca::environment<"log", cca::other_nodes>> {};

cca::deployed<split> d;
