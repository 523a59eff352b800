// EXPECT: component\.bad_result: `balance` \(balance\): `process` returns `Matrix<double, 2, 1>`, but it may return only ports \(cca::out, cca::maybe\), a cca::fault, a cca::done
// `process` returns what it publishes: ports, or a fault. The outputs of a component have different names.
#include "parts.hpp"

struct balance {
#if CCA_REJECT
  Eigen::Vector2d process(cca::in<"angles", leg_angles> angles) { return angles.vector(); }
#else
  auto process(cca::in<"angles", leg_angles> angles) -> cca::out<"torques", leg_torques> {
    return angles.vector();
  }
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
