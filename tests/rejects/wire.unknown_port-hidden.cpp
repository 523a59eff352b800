// EXPECT: wire\.unknown_port: the wire `walking\.gait\.angles` -> `recorder\.angles` in robot names `walking\.gait\.angles`, but a path into an inner graph cannot be
// What an inner graph does not expose cannot be wired.
#include "parts.hpp"

struct walking : cca::graph<cca::node<"cpg", oscillator>,
                            cca::node<"gait", gait>,
#if CCA_REJECT
                            cca::wire<"cpg.phase", "gait.phase">
#else
                            cca::wire<"cpg.phase", "gait.phase">,
                            cca::expose<"gait.angles", "angles">
#endif
                            > {
};

struct robot : cca::graph<cca::rate<1000>,
                          cca::node<"walking", walking>,
                          cca::node<"recorder", recorder>,
#if CCA_REJECT
                          cca::wire<"walking.gait.angles", "recorder.angles">
#else
                          cca::wire<"walking.angles", "recorder.angles">
#endif
                          > {
};

cca::controller<robot> c;
