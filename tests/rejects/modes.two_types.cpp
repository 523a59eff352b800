// EXPECT: modes\.two_types: `move` is oscillator in mode `walk` but stance in mode `rest`: modes share what is at a path, its state and its parameters, so give one of them another name
// A path names the same component in every mode that has it: modes share its state, and a file has its
// parameters once. All modes of a set run on the same robot.
#include <cca/modes.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"move", oscillator>, cca::node<"log", logbook>> {};
#if CCA_REJECT
struct rest : cca::graph<cca::rate<1000>, cca::node<"move", stance>, cca::node<"log", logbook>> {};
#else
struct rest : cca::graph<cca::rate<1000>, cca::node<"hold", stance>, cca::node<"log", logbook>> {};
#endif

struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"rest", rest>> {};

cca::controller<legs> c;
