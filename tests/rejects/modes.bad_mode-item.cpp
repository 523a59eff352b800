// EXPECT: modes\.bad_mode: `rest` in legs is no mode, so it would be ignored: write cca::mode<`name`, graph>
// Each item of a set of modes is a cca::mode.
#include <cca/modes.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"oscillator", oscillator>, cca::node<"log", logbook>> {};
struct rest : cca::graph<cca::rate<1000>, cca::node<"stance", stance>, cca::node<"log", logbook>> {};

struct legs : cca::modes<cca::mode<"walk", walk>,
#if CCA_REJECT
                         rest
#else
                         cca::mode<"rest", rest>
#endif
                         > {
};

cca::controller<legs> c;
