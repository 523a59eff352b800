// EXPECT: component\.no_process: `balance` \(balance\) has both `process` and `act`: a component has `process`, a resource node has `sense` and `act`; make two
// A component is called once in a beat, a resource node before and after all components: a node is one or the
// other.
#include "parts.hpp"

struct balance {
#if CCA_REJECT
  void process(cca::in<"angles", leg_angles>) {}
  void act(cca::in<"command", leg_angles>) {}
#else
  void process(cca::in<"angles", leg_angles>) {}
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
