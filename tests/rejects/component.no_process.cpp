// EXPECT: component\.no_process: `balance` \(balance\) has no `process` from which its ports could be read: give it one, public, neither overloaded nor a template
// LINES: 15
// A component has a function `process`. Its ports are read from the address of that function, so it is
// public, neither overloaded nor a template. A component is a struct, no lambda and no set of modes, and not
// const, because its state changes. What has `process` has neither `sense` nor `act`: those are of resource
// nodes, which are called before and after all components.
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
