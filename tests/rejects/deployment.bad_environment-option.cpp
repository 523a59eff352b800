// EXPECT: deployment\.bad_environment: environment `control` has the option `nodes<.*>`, but its options are cca::realtime<Priority, cca::on_core<N>>, cca::realtime_if_allowed and cca::free_running: write one of them, or none \(all nodes go into one cca::nodes<\.\.\.>\)
// An environment has one cca::nodes<...>, in which all its nodes are.
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
                               cca::environment<"control", cca::nodes<"oscillator">, cca::nodes<"gait">>,
#else
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
#endif
                               cca::environment<"log", cca::other_nodes>> {
};

cca::deployed<split> d;
