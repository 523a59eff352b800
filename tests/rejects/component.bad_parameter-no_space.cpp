// EXPECT: component\.bad_parameter: a port is of a space, and `double` is none: make one of it, as in `struct leg_angles : cca::space<
// A port states the space of its samples: a bare number has neither axes nor limits.
#include "parts.hpp"

// Refused by a static_assert of the port, before there is a graph.

struct elbow_angle : cca::space<cca::joint_angles, cca::axes<knee>> {};

struct halving {
#if CCA_REJECT
  auto process(cca::in<"angle", double> angle) -> cca::out<"half", elbow_angle> {
    return 0.5 * angle.vector();
  }
#else
  auto process(cca::in<"angle", elbow_angle> angle) -> cca::out<"half", elbow_angle> {
    return 0.5 * angle.vector();
  }
#endif
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"half", halving>,
                         cca::expose<"half.angle", "angle">,
                         cca::expose<"half.half", "half">> {};

cca::controller<walk> c;
