// EXPECT: part\.unknown_path: `orders` \(orders\) stops or starts `walkin`, but there is no node of this path in its graph, nor in the graphs around it; did you mean `walking`\?
// A component stops and starts parts by their paths: nodes of its own graph, or of a graph around it. A part
// that may be stopped is cca::stoppable: each beat then tests whether it runs. It is so in each mode that has
// it, because a part that is stopped stays stopped in the next mode.
#include "parts.hpp"

#if CCA_REJECT
using stop_walking = cca::stops<"walkin">;
#else
using stop_walking = cca::stops<"walking">;
#endif

struct orders {
  auto process(cca::beat now) -> stop_walking { return now.index() == 1000; }
};

struct walking : cca::graph<cca::node<"cpg", oscillator>,
                            cca::node<"gait", gait>,
                            cca::wire<"cpg.phase", "gait.phase">> {};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"orders", orders>,
                         cca::node<"walking", walking, cca::stoppable<>>> {};

cca::controller<walk> c;
