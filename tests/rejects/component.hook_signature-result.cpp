// EXPECT: component\.hook_signature: `balance` \(balance\) has a hook `on_load` that would never be called, because it is not `void on_load\(\)`: make it a public
// Nobody would read the result of a hook.
#include "parts.hpp"

struct balance {
  void process(cca::in<"angles", leg_angles>) {}
#if CCA_REJECT
  bool on_load() { return true; }
#else
  void on_load() {}
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
