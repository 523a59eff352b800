// EXPECT: deployment\.unplaced: `recorder` \(recorder\) of mode `logged` runs in no environment of split: add its path to the cca::nodes<\.\.\.> of one of them, or give one cca::other_nodes
// In a deployment of modes, each component of each mode has an environment.
#include <cca/deployment.hpp>
#include <cca/modes.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::node<"log", recorder>,
                         cca::wire<"oscillator.phase", "gait.phase">,
                         cca::wire<"gait.angles", "log.angles", cca::delayed<1>>> {};
struct logged : cca::graph<cca::rate<1000>,
                           cca::node<"oscillator", oscillator>,
                           cca::node<"gait", gait>,
                           cca::node<"recorder", recorder>,
                           cca::wire<"oscillator.phase", "gait.phase">,
                           cca::wire<"gait.angles", "recorder.angles", cca::delayed<1>>> {};
struct both : cca::modes<cca::mode<"walk", walk>, cca::mode<"logged", logged>> {};

struct split : cca::deployment<both,
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
#if CCA_REJECT
                               cca::environment<"log", cca::nodes<"log">>
#else
                               cca::environment<"log", cca::nodes<"log", "recorder">>
#endif
                               > {
};

cca::deployed<split> d;
