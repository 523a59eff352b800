// EXPECT: run\.no_pace: the second argument of run\(\) is no pace but `[^`]+`: write cca::as_fast_as_possible\{\}
// What is called between two beats is the third argument of run(); the pace stands before it.
// LINES: 18
#include <cca/deployment.hpp>
#include <cca/runtime/live/live_access.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"oscillator", oscillator>, cca::node<"log", logbook>> {};
struct split : cca::deployment<walk, cca::environment<"one", cca::other_nodes>> {};

void go(cca::deployed<split>& d) {
  cca::live_access live(d);
#if CCA_REJECT
  d.run(cca::for_<10>{}, live);
#else
  d.run(cca::for_<10>{}, cca::at_wall_clock(), live);
#endif
}
