// EXPECT: parameters\.unsupported_type: `balance` \(balance\): its parameter `p` is a `balance::parameters`, whose fields are unknown: name them in it with BOOST_HANA_DEFINE_STRUCT, and make it copyable
// The fields of a struct of parameters are known by their names.
#include "parts.hpp"

struct balance {
  struct parameters {
#if CCA_REJECT
    double gain = 2;
#else
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain));
#endif
  };
  parameters p{2};
  void process(cca::in<"angles", leg_angles>) {}
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
