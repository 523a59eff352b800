// EXPECT: skeleton\.arity: `mode` \(switch_between<.*>\) has 1 source, but between fewer than two there is nothing to choose or to mix: name two or more
// This switch has nothing to switch to.
#include "parts.hpp"

struct operator_panel {
  auto process(cca::beat) -> cca::out<"choice", cca::choice> { return 0; }
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"stance", stance>,
                         cca::node<"panel", operator_panel>,
                         cca::node<"recorder", recorder>,
#if CCA_REJECT
                         cca::node<"mode", cca::switch_between<"angles", leg_angles, "stance">>,
#else
                         cca::node<"mode", cca::switch_between<"angles", leg_angles, "stance", "swing">>,
                         cca::node<"swing", stance>,
                         cca::wire<"swing.angles", "mode.swing">,
#endif
                         cca::wire<"stance.angles", "mode.stance">,
                         cca::wire<"panel.choice", "mode.choice">,
                         cca::wire<"mode.angles", "recorder.angles">> {
};

cca::controller<walk> c;
