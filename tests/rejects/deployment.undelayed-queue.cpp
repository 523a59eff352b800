// EXPECT: deployment\.undelayed: .* write cca::wire<`gait\.angles`, `recorder\.angles`, cca::delayed<1>, cca::queue<4, cca::drop_oldest>>, or a greater delay, or place both in one environment
// A queue between two environments is delayed, too: its samples enter it when they arrive.
#include <cca/deployment.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::node<"recorder", recorder>,
                         cca::wire<"oscillator.phase", "gait.phase">,
#if CCA_REJECT
                         cca::wire<"gait.angles", "recorder.angles", cca::queue<4, cca::drop_oldest>>
#else
                         cca::wire<"gait.angles",
                                   "recorder.angles",
                                   cca::delayed<1>,
                                   cca::queue<4, cca::drop_oldest>>
#endif
                         > {
};

struct split : cca::deployment<walk,
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
                               cca::environment<"log", cca::other_nodes>> {};

cca::deployed<split> d;
