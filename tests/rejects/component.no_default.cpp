// EXPECT: component\.no_default: a controller makes its components, so each needs a constructor without arguments
// A component has a constructor without arguments, because a controller makes it. What differs between nodes
// is a template argument or a parameter.
#include "parts.hpp"

struct balance {
#if CCA_REJECT
  explicit balance(double stiffness) : gain(stiffness) {}
#else
  explicit balance(double stiffness = 0.5) : gain(stiffness) {}
#endif
  auto process(cca::in<"angles", leg_angles> a) -> cca::out<"angles", leg_angles> {
    return gain * a.vector();
  }
  double gain;
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"balance", balance>,
                         cca::node<"stance", stance>,
                         cca::wire<"stance.angles", "balance.angles">> {};

cca::controller<walk> c;
