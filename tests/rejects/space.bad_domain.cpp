// EXPECT: space\.bad_domain: the domain type flows does not say what is measured along its axes: add `using quantity = cca::angle;`
// A domain type says what is measured along its axes, so that limits and messages can.
#include "parts.hpp"

struct flows {
#if CCA_REJECT
#else
  using quantity = cca::speed;
#endif
  static constexpr bool actuated = false;
  static constexpr int width(int axes) { return axes; }
  static constexpr double zero(int, int) { return 0; }
  template <class Self>
  struct methods {};
};
struct flow_of_oil : cca::space<flows, cca::axes<cca::x>> {};

struct meter {
  auto process(cca::beat) -> cca::out<"flow", flow_of_oil> { return 1.0; }
};
struct walk : cca::graph<cca::rate<1000>, cca::node<"log", logbook>, cca::node<"meter", meter>> {};

cca::controller<walk> c;
