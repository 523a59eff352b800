// EXPECT: wire\.two_writers: `recorder\.angles` is written by `stance\.angles` and by `swing\.angles`, but an input has one writer: put an arbiter in front, cca::arbiter<`angles`, leg_angles, cca::by_priority<`first`, `second`>>, and wire each to an input of it
// An input has one writer; an arbiter decides which of two is read. Wires that are merged at an input lead
// into one queue, so they state the same one. An input that an inner graph exposes is wired inside or
// outside, not both.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"stance", stance>,
                         cca::node<"swing", stance>,
                         cca::node<"recorder", recorder>,
#if CCA_REJECT
                         cca::wire<"stance.angles", "recorder.angles">,
                         cca::wire<"swing.angles", "recorder.angles">
#else
                         cca::node<"arbiter",
                                   cca::arbiter<"angles", leg_angles, cca::by_priority<"first", "second">>>,
                         cca::wire<"stance.angles", "arbiter.first">,
                         cca::wire<"swing.angles", "arbiter.second">,
                         cca::wire<"arbiter.angles", "recorder.angles">
#endif
                         > {
};

cca::controller<walk> c;
