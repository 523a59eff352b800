// EXPECT: parameters\.missing_comma: a comma is missing in BOOST_HANA_DEFINE_STRUCT\(parameters.*\): put one between
// LINES: 15
// A comma stands between two fields.
#include "parts.hpp"

struct balance {
  struct parameters {
#if CCA_REJECT
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain)(double, offset));
#else
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (double, offset));
#endif
  };
  parameters p{2, 1};
  void process(cca::in<"angles", leg_angles>) {}
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
