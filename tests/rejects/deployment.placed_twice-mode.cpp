// EXPECT: deployment\.placed_twice: `recorder` \(recorder\) of mode `logged` runs in environment `control` and in environment `log`: a component runs in one environment; remove it from one of the two
// In a deployment of modes, a component has the same place in all modes.
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
                           cca::node<"recorder", recorder>,
                           cca::wire<"oscillator.phase", "gait.phase">,
                           cca::wire<"gait.angles", "recorder.angles", cca::delayed<1>>> {};
struct both : cca::modes<cca::mode<"walk", walk>, cca::mode<"logged", logged>> {};

struct split : cca::deployment<both,
#if CCA_REJECT
                               cca::environment<"control", cca::nodes<"oscillator", "gait", "recorder">>,
#else
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
#endif
                               cca::environment<"log", cca::nodes<"recorder">>> {
};

cca::deployed<split> d;
