// EXPECT: deployment\.bad_environment: cca::tolerate<-1> in split is no number of late beats: write 0 or more
// cca::tolerate<N> is how many beats in a row a sample may come late.
#include <cca/deployment.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::node<"recorder", recorder>,
                         cca::wire<"oscillator.phase", "gait.phase">,
                         cca::wire<"gait.angles", "recorder.angles", cca::delayed<1>>> {};

struct split : cca::deployment<walk,
#if CCA_REJECT
                               cca::tolerate<-1>,
#else
                               cca::tolerate<0>,
#endif
                               cca::environment<"all", cca::other_nodes>> {
};

cca::deployed<split> d;
