// EXPECT: strategy\.never_fires: `watch` \(watch\) fires only when a sample arrives, but no input that it waits for is wired: wire one, or make it cca::timed
// Samples that are observed have no origin in common: a coordinated component waits for its inputs alone.
#include "parts.hpp"

struct source {
  auto process(cca::beat) -> cca::out<"angles", leg_angles> { return Eigen::Vector2d(0, -1); }
};
struct watch {
  void process(cca::observe<"*.angles">) {}
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"source", source>,
#if CCA_REJECT
                         cca::node<"watch", watch, cca::coordinated>
#else
                         cca::node<"watch", watch>
#endif
                         > {
};

cca::controller<walk> c;
