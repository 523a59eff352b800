// EXPECT: space\.mismatch: `walking\.gait\.angles` \(exposed as `walking\.angles`\) publishes leg_angles \(joint_angles over hip, knee\) but `watch\.torques` expects leg_torques \(joint_torques over
// Ports of an inner graph are named by their own path.
#include "parts.hpp"

struct walking : cca::graph<cca::node<"cpg", oscillator>,
                            cca::node<"gait", gait>,
                            cca::wire<"cpg.phase", "gait.phase">,
                            cca::expose<"gait.angles", "angles">> {};

struct watch {
  void process(cca::optional_in<"angles", leg_angles>, cca::optional_in<"torques", leg_torques>) {}
};

struct robot : cca::graph<cca::rate<1000>,
                          cca::node<"walking", walking>,
                          cca::node<"watch", watch>,
#if CCA_REJECT
                          cca::wire<"walking.angles", "watch.torques">
#else
                          cca::wire<"walking.angles", "watch.angles">
#endif
                          > {
};

cca::controller<robot> c;
