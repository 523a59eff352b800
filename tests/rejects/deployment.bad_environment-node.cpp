// EXPECT: deployment\.bad_environment: `legs` is the deployment split, but inside of a graph its environments would be ignored: make it a node of the architecture, walk, and deploy the graph around it
// A deployment is no node of a graph; its architecture can be one.
#include <cca/deployment.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::node<"recorder", recorder>,
                         cca::wire<"oscillator.phase", "gait.phase">,
                         cca::wire<"gait.angles", "recorder.angles", cca::delayed<1>>> {};

struct split : cca::deployment<walk,
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
                               cca::environment<"log", cca::other_nodes>> {};

#if CCA_REJECT
struct robot : cca::graph<cca::rate<1000>, cca::node<"legs", split>> {};

cca::controller<robot> c;
#else
struct robot : cca::graph<cca::rate<1000>, cca::node<"legs", walk>> {};
struct split_robot : cca::deployment<robot,
                                     cca::environment<"control", cca::nodes<"legs.oscillator", "legs.gait">>,
                                     cca::environment<"log", cca::other_nodes>> {};

cca::deployed<split_robot> d;
#endif
