// EXPECT: observe\.queue: `log` \(log_of<.*>\) observes `gait\.\*\*`, and so the input `gait\.phase` later than it is read, but that has a queue, and what waits in a queue is gone once it was read: observe the outputs alone, with `gait\.\*\*\.\*`
// What waits in a queue is shown while it waits: an observer hears it in the same environment, without a
// delay.
#include "parts.hpp"

template <class Heard>
struct log_of {
  void process(Heard) {}
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait, cca::timed<1>>,
                         cca::wire<"oscillator.phase", "gait.phase", cca::queue<4, cca::drop_oldest>>,
#if CCA_REJECT
                         cca::node<"log", log_of<cca::observe<"gait.**", cca::delayed<1>>>>
#else
                         cca::node<"log", log_of<cca::observe<"gait.**.*", cca::delayed<1>>>>
#endif
                         > {
};

cca::controller<walk> c;
