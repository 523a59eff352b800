// EXPECT: component\.hook_signature: `balance` \(balance\) has a hook `on_start` that would never be called, because it is not `void on_start\(\)`: make it a public
// A hook with the right name and another signature would be ignored silently. It is called from outside, so
// it is public, and nobody would read its result.
#include "parts.hpp"

struct balance {
  void process(cca::in<"angles", leg_angles>) {}
#if CCA_REJECT
  void on_start(cca::beat) {}
#else
  void on_start() {}
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
