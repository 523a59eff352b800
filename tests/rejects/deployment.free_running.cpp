// EXPECT: deployment\.free_running: `recorder` \(recorder\) runs in environment `log`, whose cycles begin without pause, but its strategy is restless: write cca::node<`recorder`, recorder, cca::full_speed>, or place it in another environment
// The cycles of a free-running environment begin without pause, so its components are full_speed, in each
// mode: they fire in each cycle. It is not the first environment, which gives the beat to the others.
#include <cca/deployment.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
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

struct split : cca::deployment<walk,
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
                               cca::environment<"log", cca::other_nodes, cca::free_running>> {};

cca::deployed<split> d;
