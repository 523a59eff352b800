// EXPECT: deployment\.undelayed: .* write cca::wire<`stance\.angles`, `recorder\.angles`, cca::delayed<1>>, or a greater delay, or place both in one environment, or give environment `eyes` cca::free_running, because all that it runs is cca::full_speed
// An environment of components that are full_speed can run freely; its wires then need no delay.
#include <cca/deployment.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stance", stance>,
                         cca::node<"recorder", recorder, cca::full_speed>,
                         cca::wire<"stance.angles", "recorder.angles">> {};

struct split : cca::deployment<walk,
                               cca::environment<"control", cca::nodes<"stance">>,
#if CCA_REJECT
                               cca::environment<"eyes", cca::other_nodes>
#else
                               cca::environment<"eyes", cca::other_nodes, cca::free_running>
#endif
                               > {
};

cca::deployed<split> d;
