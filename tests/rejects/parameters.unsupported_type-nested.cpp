// EXPECT: parameters\.unsupported_type: `balance` \(balance\): its parameter `hip_spring` is a `balance::spring`, which no file can hold: use a number, bool, enum
// A struct within the parameters names its fields too.
#include "parts.hpp"

struct balance {
  struct spring {
#if CCA_REJECT
    double stiffness = 1, rest = 0;
#else
    BOOST_HANA_DEFINE_STRUCT(spring, (double, stiffness), (double, rest));
#endif
  };
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (spring, hip_spring));
  };
  parameters p{};
  void process(cca::in<"angles", leg_angles>) {}
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
