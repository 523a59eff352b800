// EXPECT: component\.hook_signature: `balance` \(balance\) has a hook `on_fault` that would never be called, because it is not `void on_fault\(\)`: make it a public
// A correct hook does not hide a wrong one.
#include "parts.hpp"

struct balance {
  void process(cca::in<"angles", leg_angles>) {}
  void on_load() {}
#if CCA_REJECT
  void on_fault(const char*) {}
#else
  void on_fault() {}
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
