// EXPECT: strategy\.never_fires: `watch` \(watch\) fires only when a sample arrives, but no input that it waits for is wired: wire one, or make it cca::timed
// Wire the input that the component waits for.
#include "parts.hpp"

struct watch {
  void process(cca::in<"angles", leg_angles>, cca::optional_in<"torques", leg_torques>) {}
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
#if CCA_REJECT
                         cca::node<"watch", watch, cca::port_triggered<"torques">>,
#else
                         cca::node<"watch", watch, cca::port_triggered<"angles">>,
#endif
                         cca::wire<"stance.angles", "watch.angles">> {
};

cca::controller<walk> c;
