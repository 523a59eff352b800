// EXPECT: deployment\.undelayed: `log\.stance\.angles` is published in environment `control` and read in environment `log`, so it takes at least a beat to get there: write cca::wire<`stance\.angles`, `recorder\.angles`, cca::delayed<1>> in logging, or a greater
// A wire inside of an inner graph is delayed too, if its components run in two environments.
#include <cca/deployment.hpp>

#include "parts.hpp"

struct logging : cca::graph<cca::node<"stance", stance>,
                            cca::node<"recorder", recorder>,
#if CCA_REJECT
                            cca::wire<"stance.angles", "recorder.angles">
#else
                            cca::wire<"stance.angles", "recorder.angles", cca::delayed<1>>
#endif
                            > {
};

struct walk : cca::graph<cca::rate<1000>, cca::node<"log", logging>> {};

struct split : cca::deployment<walk,
                               cca::environment<"control", cca::nodes<"log.stance">>,
                               cca::environment<"log", cca::other_nodes>> {};

cca::deployed<split> d;
