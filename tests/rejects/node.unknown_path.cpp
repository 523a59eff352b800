// EXPECT: node\.unknown_path: walk has no node `raech`; did you mean `reach`\?
// `get` and `set` name a node by its path from the outermost graph.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"log", logbook>, cca::node<"reach", stance>> {};

void use(cca::controller<walk>& c) {
#if CCA_REJECT
  c.get<"raech">();
#else
  c.get<"reach">();
#endif
}
