// EXPECT: modes\.bad_mode: two modes of legs are named `walk`, so to switch to it has two meanings: give one another name
// Each mode has a name of its own.
#include <cca/modes.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"oscillator", oscillator>, cca::node<"log", logbook>> {};
struct rest : cca::graph<cca::rate<1000>, cca::node<"stance", stance>, cca::node<"log", logbook>> {};

struct legs : cca::modes<cca::mode<"walk", walk>,
#if CCA_REJECT
                         cca::mode<"walk", rest>
#else
                         cca::mode<"rest", rest>
#endif
                         > {
};

cca::controller<legs> c;
