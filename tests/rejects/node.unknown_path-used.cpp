// EXPECT: node\.unknown_path: walk has no node `raech`; did you mean `reach`\?
// LINES: 15
// Nothing else is reported where the component is used.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>, cca::node<"log", logbook>, cca::node<"reach", stance>> {};

auto use(cca::controller<walk>& c) {
#if CCA_REJECT
  auto& reach = c.get<"raech">();
#else
  auto& reach = c.get<"reach">();
#endif
  return reach.process(cca::beat(0, 1'000'000, 1));
}
