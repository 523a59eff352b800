// EXPECT: modes\.bad_mode: legs has 1 mode, so there is nothing to switch to: write two or more, cca::mode<`name`, graph>, or run the graph by itself in a cca::controller
// A set of modes has two or more. Each is a cca::mode: a name of its own, and a graph. A deployment or
// another set of modes can't stand there.
#include <cca/modes.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"oscillator", oscillator>, cca::node<"log", logbook>> {};
struct rest : cca::graph<cca::rate<1000>, cca::node<"stance", stance>, cca::node<"log", logbook>> {};

struct legs : cca::modes<
#if CCA_REJECT
                  cca::mode<"walk", walk>
#else
                  cca::mode<"walk", walk>,
                  cca::mode<"rest", rest>
#endif
                  > {
};

cca::controller<legs> c;
