// EXPECT: modes\.two_rates: mode `walk` of legs runs at 1000 Hz but mode `rest` at 100 Hz: all modes share the beat, so give both graphs the same cca::rate<\.\.\.>, and what is slower a cca::timed<N>
// All modes of a set have the same rate: the beats go on at a switch.
#include <cca/modes.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"oscillator", oscillator>, cca::node<"log", logbook>> {};
#if CCA_REJECT
struct rest : cca::graph<cca::rate<100>, cca::node<"stance", stance>, cca::node<"log", logbook>> {};
#else
struct rest
    : cca::graph<cca::rate<1000>, cca::node<"stance", stance, cca::timed<10>>, cca::node<"log", logbook>> {};
#endif

struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"rest", rest>> {};

cca::controller<legs> c;
