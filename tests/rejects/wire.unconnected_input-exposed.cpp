// EXPECT: wire\.unconnected_input: `log\.recorder\.angles` is not connected: in robot, wire an output of leg_angles \(joint_angles over hip, knee\) to `log\.angles`,
// What an inner graph exposes is wired outside.
#include "parts.hpp"

struct logging : cca::graph<cca::node<"recorder", recorder>, cca::expose<"recorder.angles", "angles">> {};

struct robot : cca::graph<cca::rate<1000>,
#if CCA_REJECT
                          cca::node<"log", logging>
#else
                          cca::node<"log", logging>,
                          cca::node<"stance", stance>,
                          cca::wire<"stance.angles", "log.angles">
#endif
                          > {
};

cca::controller<robot> c;
