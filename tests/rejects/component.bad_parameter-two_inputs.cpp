// EXPECT: component\.bad_parameter: `balance` \(balance\) has two inputs named `angles`, so a wire to it would have two meanings: give one of them another name
// The inputs of a component have different names.
#include "parts.hpp"

struct balance {
#if CCA_REJECT
  void process(cca::in<"angles", leg_angles>, cca::in<"angles", leg_torques>) {}
#else
  void process(cca::in<"angles", leg_angles>, cca::optional_in<"torques", leg_torques>) {}
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
