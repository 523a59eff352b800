// EXPECT: deployment\.free_running: environment `log` of split is cca::free_running, but the environments of a set of modes switch in one beat, and its cycles are no beats: remove cca::free_running, or deploy one graph, and stop parts of it
// All environments of a set of modes switch in the same beat. The cycles of a free-running one are no beats.
#include <cca/deployment.hpp>
#include <cca/modes.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::wire<"oscillator.phase", "gait.phase">> {};
struct logged : cca::graph<cca::rate<1000>,
                           cca::node<"oscillator", oscillator>,
                           cca::node<"gait", gait>,
                           cca::node<"recorder", recorder, cca::full_speed>,
                           cca::wire<"oscillator.phase", "gait.phase">,
                           cca::wire<"gait.angles", "recorder.angles", cca::delayed<1>>> {};
struct both : cca::modes<cca::mode<"walk", walk>, cca::mode<"logged", logged>> {};

struct split : cca::deployment<both,
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
#if CCA_REJECT
                               cca::environment<"log", cca::other_nodes, cca::free_running>
#else
                               cca::environment<"log", cca::other_nodes>
#endif
                               > {
};

cca::deployed<split> d;
