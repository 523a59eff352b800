// EXPECT: deployment\.free_running: `recorder` \(recorder\) of mode `logged` runs in environment `log`, whose cycles begin without pause, but its strategy is restless: write cca::node<`recorder`, recorder, cca::full_speed>, or place it in another environment
// In a deployment of modes the components of a free-running environment are full_speed in each mode.
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
#if CCA_REJECT
                           cca::node<"recorder", recorder>,
#else
                           cca::node<"recorder", recorder, cca::full_speed>,
#endif
                           cca::wire<"oscillator.phase", "gait.phase">,
                           cca::wire<"gait.angles", "recorder.angles">> {
};
struct both : cca::modes<cca::mode<"walk", walk>, cca::mode<"logged", logged>> {};

struct split : cca::deployment<both,
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
                               cca::environment<"log", cca::other_nodes, cca::free_running>> {};

cca::deployed<split> d;
