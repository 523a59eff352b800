// EXPECT: wire\.unconnected_input: `gait\.phase` is not connected: in walk, wire an output of gait_phase
// Each mode is checked as a graph by itself, and reported as such.
#include <cca/modes.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
#if !CCA_REJECT
                         cca::wire<"oscillator.phase", "gait.phase">,
#endif
                         cca::node<"log", logbook>> {
};
struct rest : cca::graph<cca::rate<1000>, cca::node<"stance", stance>, cca::node<"log", logbook>> {};

struct legs : cca::modes<cca::mode<"rest", rest>, cca::mode<"walk", walk>> {};

cca::controller<legs> c;
