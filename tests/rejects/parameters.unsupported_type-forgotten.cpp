// EXPECT: parameters\.unsupported_type: `balance` \(balance\) has a struct `parameters` but no public member `parameters p`, so nothing would ever set them: add
// Parameters that no member holds would never be set.
#include "parts.hpp"

struct balance {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain));
  };
  void process(cca::in<"angles", leg_angles>) {}
#if CCA_REJECT
  double gain = 2;
#else
  parameters p{2};
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
