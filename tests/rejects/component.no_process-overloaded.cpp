// EXPECT: component\.no_process: `balance` \(balance\) has no `process` from which its ports could be read: give it one, public, neither overloaded nor a template
// Ports are read from the address of `process`, so it cannot be overloaded.
#include "parts.hpp"

struct balance {
#if CCA_REJECT
  void process(cca::in<"angles", leg_angles>) {}
  void process(cca::in<"torques", leg_torques>) {}
#else
  void process(cca::in<"angles", leg_angles>) {}
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
