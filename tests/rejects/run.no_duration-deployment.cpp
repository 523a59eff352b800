// EXPECT: run\.no_duration: the first argument of run\(\) is no duration but `[a-z_<> ]+`: write cca::for_<10>\{\} for seconds
// A deployment takes a duration as well, and it stands first.
// LINES: 18
#include <cca/deployment.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"oscillator", oscillator>, cca::node<"log", logbook>> {};
struct split : cca::deployment<walk, cca::environment<"one", cca::other_nodes>> {};

void go(cca::deployed<split>& d) {
#if CCA_REJECT
  d.run(cca::at_wall_clock(), cca::for_<10>{});
#else
  d.run(cca::for_<10>{}, cca::at_wall_clock());
#endif
}
