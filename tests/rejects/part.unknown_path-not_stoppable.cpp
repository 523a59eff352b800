// EXPECT: part\.unknown_path: `orders` \(orders\) stops or starts `walking`, but its node does not let it be stopped: write cca::stoppable<> as the strategy of the graph
// A part that may be stopped says so, because each beat then tests whether it runs.
#include "parts.hpp"

struct orders {
  auto process(cca::beat now) -> cca::stops<"walking"> { return now.index() == 1000; }
};

struct walking : cca::graph<cca::node<"cpg", oscillator>,
                            cca::node<"gait", gait>,
                            cca::wire<"cpg.phase", "gait.phase">> {};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"orders", orders>,
#if CCA_REJECT
                         cca::node<"walking", walking>
#else
                         cca::node<"walking", walking, cca::stoppable<>>
#endif
                         > {
};

cca::controller<walk> c;
