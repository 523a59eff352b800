// EXPECT: skeleton\.arity: `split` \(splitter<.*>\) is to take attitude apart, which has 4 numbers over 3 axes, so none of them belongs to one axis
// A quaternion has no number for each axis.
#include "parts.hpp"

#if CCA_REJECT
using measured = attitude;
#else
using measured = place;
#endif

struct inertial_unit {
  auto process(cca::beat) -> cca::out<"trunk", measured> { return {}; }
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"trunk", inertial_unit>,
                         cca::node<"split", cca::splitter<"trunk", measured>>,
                         cca::wire<"trunk.trunk", "split.trunk">> {};

cca::controller<walk> c;
