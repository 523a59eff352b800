// EXPECT: node\.unknown_path: walk has no node `leg\.raech`; did you mean `leg\.reach`\?
// The same for a node of an inner graph.
#include "parts.hpp"

struct motion : cca::graph<cca::node<"reach", stance>, cca::expose<"reach.angles", "angles">> {};
struct walk : cca::graph<cca::rate<1000>, cca::node<"log", logbook>, cca::node<"leg", motion>> {};

void use(cca::controller<walk>& c) {
#if CCA_REJECT
  c.get<"leg">().get<"raech">();
#else
  c.get<"leg">().get<"reach">();
#endif
}
