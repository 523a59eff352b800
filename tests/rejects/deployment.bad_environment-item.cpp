// EXPECT: deployment\.bad_environment: `recorder` in split is no item of a deployment, so it would be ignored: write cca::environment<`name`, cca::nodes<`a`, `b\.c`>>, or cca::tolerate<N>
// A deployment has no other items than environments and cca::tolerate.
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
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
                               recorder
#else
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
                               cca::environment<"log", cca::nodes<"recorder">>
#endif
                               > {
};

cca::deployed<split> d;
