// EXPECT: component\.bad_parameter: `balance` \(balance\): `process` takes `double`, but it may take only ports \(cca::in, cca::optional_in, cca::observe\), a cca::derived of one of them and the
// `process` takes what the loop can provide: ports, what is derived from them, and the beat. It cannot change
// what it sees, because others read it too. Outputs are returned, not filled in. The inputs of a component
// have different names.
#include "parts.hpp"

struct balance {
#if CCA_REJECT
  void process(cca::in<"angles", leg_angles>, double gain) { state *= gain; }
  double state = 1;
#else
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain));
  };
  parameters p{2};
  void process(cca::in<"angles", leg_angles>) { state *= p.gain; }
  double state = 1;
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
