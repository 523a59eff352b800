// EXPECT: graph\.unknown_item: `gait` in split is no graph: the first argument of cca::deployment is the architecture, a struct derived from cca::graph<\.\.\.> or, of several modes, from cca::modes<\.\.\.>, and the environments follow
// The first argument of a deployment is its architecture.
#include <cca/deployment.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::node<"recorder", recorder>,
                         cca::wire<"oscillator.phase", "gait.phase">,
                         cca::wire<"gait.angles", "recorder.angles", cca::delayed<1>>> {};

struct split : cca::deployment<
#if CCA_REJECT
                   gait,
#else
                   walk,
#endif
                   cca::environment<"robot", cca::other_nodes>> {
};

cca::deployed<split> d;
