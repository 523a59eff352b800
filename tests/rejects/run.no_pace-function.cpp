// EXPECT: run\.no_pace: the second argument of run\(\) is no pace but `a function`: write cca::as_fast_as_possible\{\}
// The same of a controller and a function.
// LINES: 18
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"oscillator", oscillator>, cca::node<"log", logbook>> {};

void go(cca::controller<walk>& c) {
#if CCA_REJECT
  c.run(cca::for_<10>{}, [](auto& now) { return now.beat_index() < 500; });
#else
  c.run(cca::for_<10>{}, cca::as_fast_as_possible{}, [](auto& now) { return now.beat_index() < 500; });
#endif
}
