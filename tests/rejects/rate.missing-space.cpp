// EXPECT: rate\.missing: the third argument of a space is its rate, as `cca::rate<1000>`, and `int` is none; where none is meant, leave it out
// Of a space, a rate is a `cca::rate` of a number above 0. Before it is that of a graph, so no value of
// `cca::diagnosis`. LINES: 15
#include "parts.hpp"

#if CCA_REJECT
struct fast_hip : cca::space<cca::joint_angles, cca::axes<hip>, int> {};
#else
struct fast_hip : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};
#endif

struct swing {
  auto process(cca::beat) -> cca::out<"angle", fast_hip> { return 0.1; }
};
struct walk
    : cca::graph<cca::node<"swing", swing>, cca::node<"log", logbook>, cca::wire<"swing.angle", "log.in">> {};
