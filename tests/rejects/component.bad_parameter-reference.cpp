// EXPECT: component\.bad_parameter: `balance` \(balance\): `process` takes `in<angles, leg_angles>&`, but it may take only ports \(cca::in, cca::optional_in,
// A component cannot change what it sees: others read it too.
#include "parts.hpp"

struct balance {
#if CCA_REJECT
  void process(cca::in<"angles", leg_angles>&) {}
#else
  void process(const cca::in<"angles", leg_angles>&) {}
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
