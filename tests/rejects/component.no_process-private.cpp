// EXPECT: component\.no_process: `balance` \(balance\) has no `process`: give it one public function, neither overloaded nor a template, as in `auto
// `process` is called from outside.
#include "parts.hpp"

class balance {
#if CCA_REJECT
  void process(cca::in<"angles", leg_angles>) {}
#else
  public:
  void process(cca::in<"angles", leg_angles>) {}
#endif
};

struct walk : cca::graph<cca::rate<1000>, cca::node<"balance", balance>, cca::node<"stance", stance>, cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
