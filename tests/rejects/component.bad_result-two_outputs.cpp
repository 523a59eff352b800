// EXPECT: component\.bad_result: `balance` \(balance\) has two outputs named `torques`, so a wire to it would have two meanings: give one of them another name
// The outputs of a component have different names.
#include "parts.hpp"

struct balance {
#if CCA_REJECT
  auto process(cca::in<"angles", leg_angles>)
      -> std::tuple<cca::out<"torques", leg_torques>, cca::out<"torques", leg_angles>> {
    return {};
  }
#else
  auto process(cca::in<"angles", leg_angles>)
      -> std::tuple<cca::out<"torques", leg_torques>, cca::out<"angles", leg_angles>> {
    return {};
  }
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
