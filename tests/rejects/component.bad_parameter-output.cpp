// EXPECT: component\.bad_parameter: `balance` \(balance\): `process` takes `out<torques, leg_torques>`, but it may take only ports \(cca::in, cca::optional_in,
// Outputs are returned, not filled in.
#include "parts.hpp"

struct balance {
#if CCA_REJECT
  void process(cca::in<"angles", leg_angles>, cca::out<"torques", leg_torques>) {}
#else
  auto process(cca::in<"angles", leg_angles>) -> cca::out<"torques", leg_torques> { return {}; }
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
