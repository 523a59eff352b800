// EXPECT: component\.no_process: `balance` \(balance\) has no `process` from which its ports could be read: give it one, public, neither overloaded nor a template
// A template has no signature from which ports could be read.
#include "parts.hpp"

struct balance {
#if CCA_REJECT
  template <class Angles>
  void process(Angles) {}
#else
  void process(cca::in<"angles", leg_angles>) {}
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
