// EXPECT: wire\.two_writers: `log\.compare\.wanted` is written by `swing\.angles` and by `log\.stance\.angles`, but an input has one writer: put an arbiter in front, cca::arbiter<
// An input that an inner graph exposes is wired inside or outside, not both.
#include "parts.hpp"

struct logging : cca::graph<cca::node<"stance", stance>,
                            cca::node<"compare", comparison>,
                            cca::wire<"stance.angles", "compare.wanted">,
                            cca::expose<"compare.wanted", "angles">,
                            cca::expose<"compare.actual", "other">> {};

struct robot : cca::graph<cca::rate<1000>,
                          cca::node<"swing", stance>,
                          cca::node<"log", logging>,
#if CCA_REJECT
                          cca::wire<"swing.angles", "log.angles">
#else
                          cca::wire<"swing.angles", "log.other">
#endif
                          > {
};

cca::controller<robot> c;
