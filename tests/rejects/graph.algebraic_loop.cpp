// EXPECT: graph\.algebraic_loop: `wish\.angles` -> `reality\.angles`, `reality\.angles` -> `wish\.angles` are a loop without delay, so none of their components can
// In a loop of wires without delay no component can come first. The message shows the whole loop, through
// inner graphs too. What a robot senses in a beat cannot depend on what is computed in that beat.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"wish", posture>,
                         cca::node<"reality", posture>,
                         cca::wire<"wish.angles", "reality.angles">,
#if CCA_REJECT
                         cca::wire<"reality.angles", "wish.angles">
#else
                         cca::wire<"reality.angles", "wish.angles", cca::delayed<1>>
#endif
                         > {
};

cca::controller<walk> c;
