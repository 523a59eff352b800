// EXPECT: wire\.unconnected_input: `log\.recorder\.angles` is not connected: in logging, wire an output of leg_angles \(joint_angles over hip, knee\) to
// What an inner graph does not expose is wired inside.
#include "parts.hpp"

struct logging : cca::graph<cca::node<"stance", stance>,
#if CCA_REJECT
                            cca::node<"recorder", recorder>
#else
                            cca::node<"recorder", recorder>,
                            cca::wire<"stance.angles", "recorder.angles">
#endif
                            > {
};

struct robot : cca::graph<cca::rate<1000>, cca::node<"log", logging>> {};

cca::controller<robot> c;
