// EXPECT: run\.no_duration: the first argument of run\(\) is no duration but `int`: write cca::for_<10>\{\} for seconds
// run() takes a duration, which says whether it means seconds or beats.
// LINES: 18
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"oscillator", oscillator>, cca::node<"log", logbook>> {};

void go(cca::controller<walk>& c) {
#if CCA_REJECT
  c.run(10);
#else
  c.run(cca::for_<10>{});
#endif
}
