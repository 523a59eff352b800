// EXPECT: component\.hook_signature: `balance` \(balance\) has a hook `on_stop` that would never be called, because it is not `void on_stop\(\)`: make it a public
// A hook is called from outside.
#include "parts.hpp"

class balance {
public:
  void process(cca::in<"angles", leg_angles>) {}
#if CCA_REJECT
private:
  void on_stop() {}
#else
  void on_stop() {}
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
