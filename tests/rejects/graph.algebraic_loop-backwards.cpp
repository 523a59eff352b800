// EXPECT: graph\.algebraic_loop: `posture\.angles` -> `eye\.expected` leads back within a beat, which is: every sense, then every component, then every act; say
// What a robot senses in a beat cannot depend on what is computed in that beat.
#include "parts.hpp"

struct eye {
  auto sense(cca::in<"expected", leg_angles> expected) -> cca::out<"angles", leg_angles> { return expected; }
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"eye", eye>,
                         cca::node<"posture", posture>,
                         cca::wire<"eye.angles", "posture.angles">,
#if CCA_REJECT
                         cca::wire<"posture.angles", "eye.expected">
#else
                         cca::wire<"posture.angles", "eye.expected", cca::delayed<1>>
#endif
                         > {
};

cca::controller<walk> c;
