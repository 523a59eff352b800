// EXPECT: deployment\.unplaced: `comparison` \(recorder\) runs in no environment of split
// LINES: 15
// cca::check takes deployments too.
#include <cca/deployment.hpp>

#include "parts.hpp"

// A diagnosis does not tell how often the compiler says it.

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"comparison", recorder>,
                         cca::wire<"stance.angles", "comparison.angles", cca::delayed<1>>> {};

struct split : cca::deployment<walk,
#if CCA_REJECT
                               cca::environment<"robot", cca::nodes<"stance">>
#else
                               cca::environment<"robot", cca::nodes<"stance">>,
                               cca::environment<"mind", cca::other_nodes>
#endif
                               > {
};

static_assert(cca::check<split>());

cca::deployed<split> d;
