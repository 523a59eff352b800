// EXPECT: parameters\.unsupported_type: `balance` \(balance\): its parameter `model` is a `std::string`, which no file can hold: use a number, bool, enum class,
// A file can hold every parameter, and knows each by its name: name the fields of a struct within the
// parameters, too. A member `parameters p` holds them.
#include <string>

#include "parts.hpp"

struct balance {
  struct parameters {
#if CCA_REJECT
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (std::string, model));
#else
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (cca::text<32>, model));
#endif
  };
  parameters p{};
  void process(cca::in<"angles", leg_angles>) {}
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
