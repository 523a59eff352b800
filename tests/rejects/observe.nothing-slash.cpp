// EXPECT: observe\.nothing: `listener` \(listener\) observes `/stance/\*\*`, which names nothing in walk, the outermost graph, so it would hear nothing: names are joined by dots
// The names of a pattern are joined by dots; a `/` in front means the outermost graph.
#include "parts.hpp"

struct listener {
#if CCA_REJECT
  void process(cca::observe<"/stance/**">) {}
#else
  void process(cca::observe<"/stance.**">) {}
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"stance", stance>,
                         cca::node<"listener", listener>> {};

cca::controller<walk> c;
