// EXPECT: deployment\.free_running: environment `log` is the first of split, which gives the beat, but a cca::free_running one has none: put the environment of the robot before it
// The first environment gives the beat to the others. The cycles of a free-running one follow no beat.
#include <cca/deployment.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::node<"recorder", recorder, cca::full_speed>,
                         cca::wire<"oscillator.phase", "gait.phase">,
                         cca::wire<"gait.angles", "recorder.angles">> {};

using control = cca::environment<"control", cca::nodes<"oscillator", "gait">>;
using log_of_all = cca::environment<"log", cca::other_nodes, cca::free_running>;

struct split : cca::deployment<walk,
#if CCA_REJECT
                               log_of_all,
                               control
#else
                               control,
                               log_of_all
#endif
                               > {
};

cca::deployed<split> d;
