// EXPECT: component\.no_process: `balance` \(balance\) has no `process` from which its ports could be read: give it one, public, neither overloaded nor a template
// A component has a function `process`.
#include "parts.hpp"

struct balance {
#if CCA_REJECT
  auto update(cca::in<"angles", leg_angles> a) -> cca::out<"angles", leg_angles> { return a; }
#else
  auto process(cca::in<"angles", leg_angles> a) -> cca::out<"angles", leg_angles> { return a; }
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
