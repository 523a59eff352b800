// EXPECT: modes\.bad_mode: legs has 1 mode, so there is nothing to switch to: write two or more, cca::mode<`name`, graph>, or run the graph by itself in a cca::controller
// A set of modes has two or more. Each is a cca::mode with a name of its own and a graph, which is neither a
// deployment nor a set of modes.
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
