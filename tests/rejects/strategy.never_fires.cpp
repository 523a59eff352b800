// EXPECT: strategy\.never_fires: `watch` \(watch\) fires only when a sample arrives, but no input that it waits for is wired: wire one, or make it cca::timed
// A component that waits for its inputs needs one that is wired. A coordinated one waits for its inputs only,
// not for what it observes. Clocks under `all_of` need a beat in common. A number of beats is at least 1.
#include "parts.hpp"

struct watch {
  void process(cca::optional_in<"angles", leg_angles>) {}
};

struct walk : cca::graph<cca::rate<1000>,
#if CCA_REJECT
                         cca::node<"watch", watch>
#else
                         cca::node<"watch", watch, cca::timed<10>>
#endif
                         > {
};

cca::controller<walk> c;
