// EXPECT: space\.duplicate_axis: the space spread of `balance\.spread` has the axis `hip` twice, so reading along it has two meanings: name each axis once in
// An axis stands for one coordinate of a space.
#include "parts.hpp"

#if CCA_REJECT
struct spread : cca::space<cca::joint_angles, cca::axes<hip, hip>> {};
#else
struct spread : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
#endif
struct balance {
  auto process(cca::in<"angles", leg_angles>) -> cca::out<"spread", spread> { return {}; }
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
