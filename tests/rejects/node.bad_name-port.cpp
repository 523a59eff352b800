// EXPECT: node\.bad_name: a port of `balance` \(balance\) is named `angles\.left`, but dots join names to paths, and `\*` stands for any name: use
// Ports are named in paths too.
#include "parts.hpp"

struct balance {
#if CCA_REJECT
  auto process(cca::beat) -> cca::out<"angles.left", leg_angles> { return {}; }
#else
  auto process(cca::beat) -> cca::out<"angles_left", leg_angles> { return {}; }
#endif
};

struct walk : cca::graph<cca::rate<1000>, cca::node<"log", logbook>, cca::node<"balance", balance>> {};

cca::controller<walk> c;
