// EXPECT: component\.no_process: `legs` \(legs\) is a set of modes, which is no node: a mode holds the whole architecture, so put the other nodes of robot into its modes, and give the set to a controller or a deployment
// A set of modes is no node of a graph.
#include <cca/modes.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"oscillator", oscillator>, cca::node<"log", logbook>> {};
struct rest : cca::graph<cca::rate<1000>, cca::node<"stance", stance>, cca::node<"log", logbook>> {};
struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"rest", rest>> {};

struct robot : cca::graph<cca::rate<1000>,
#if CCA_REJECT
                          cca::node<"legs", legs>
#else
                          cca::node<"legs", walk>
#endif
                          > {
};

cca::controller<robot> c;
