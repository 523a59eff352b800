// EXPECT: plan\.bad_step: an item of cca::steps is `after<100>`, which is no step: write conditions and options inside a step
// A plan consists of steps; its conditions stand in them.
// LINES: 20
#include <cca/adaptive/sequencer.hpp>

#include "parts.hpp"

struct plan : cca::steps<cca::step<"rest">,
#if CCA_REJECT
                         cca::after<100>
#else
                         cca::step<"reach", cca::after<100>>
#endif
                         > {
};

struct reader {
  void process(cca::in<"step", cca::step_port> s) { reaches = s[cca::step_axis{}] == plan::at<"reach">; }
  bool reaches = false;
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"plan", cca::sequencer<"stance.*", plan>>,
                         cca::node<"reader", reader>,
                         cca::node<"log", logbook>,
                         cca::wire<"plan.step", "reader.step">> {};

cca::controller<walk> c;
