// EXPECT: skeleton\.arity: `whole` \(collector<.*>\) is to put attitude together, which has 4 numbers over 3 axes, so it is not made of one for each
// A quaternion cannot be made of one number for each axis.
#include "parts.hpp"

#if CCA_REJECT
using measured = attitude;
#else
using measured = place;
#endif

template <class Axis>
struct encoder {
  auto process(cca::beat) -> cca::out<"value", cca::sub_space<place, Axis>> { return {}; }
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"x", encoder<cca::x>>,
                         cca::node<"y", encoder<cca::y>>,
                         cca::node<"z", encoder<cca::z>>,
                         cca::node<"whole", cca::collector<"place", measured>, cca::moderate>,
                         cca::wire<"x.value", "whole.x">,
                         cca::wire<"y.value", "whole.y">,
                         cca::wire<"z.value", "whole.z">> {};

cca::controller<walk> c;
