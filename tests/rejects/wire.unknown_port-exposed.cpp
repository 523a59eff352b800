// EXPECT: wire\.unknown_port: cca::expose<`gait\.angle`, `angles`> in walk names `gait\.angle`, but `gait` \(gait\) has no such port; did you mean `gait\.angles`\?
// A graph exposes a port that exists inside.
#include "parts.hpp"

struct walk : cca::graph<cca::node<"cpg", oscillator>,
                         cca::node<"gait", gait>,
                         cca::wire<"cpg.phase", "gait.phase">,
#if CCA_REJECT
                         cca::expose<"gait.angle", "angles">
#else
                         cca::expose<"gait.angles", "angles">
#endif
                         > {
};

struct robot : cca::graph<cca::rate<1000>, cca::node<"log", logbook>, cca::node<"walking", walk>> {};

cca::controller<robot> c;
