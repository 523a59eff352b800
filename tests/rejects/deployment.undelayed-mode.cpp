// EXPECT: deployment\.undelayed: `gait\.angles` of mode `logged` is published in environment `control` and read in environment `log`, so it takes at least a beat to get there: write cca::wire<`gait\.angles`, `recorder\.angles`, cca::delayed<1>>, or a greater delay
// In a deployment of modes, a wire that crosses environments is delayed in each mode that has it.
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
#if CCA_REJECT
                           cca::wire<"gait.angles", "recorder.angles">
#else
                           cca::wire<"gait.angles", "recorder.angles", cca::delayed<1>>
#endif
                           > {
};
struct both : cca::modes<cca::mode<"walk", walk>, cca::mode<"logged", logged>> {};

struct split : cca::deployment<both,
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
                               cca::environment<"log", cca::other_nodes>> {};

cca::deployed<split> d;
