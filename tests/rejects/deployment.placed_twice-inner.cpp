// EXPECT: deployment\.placed_twice: `log\.stance` \(stance\) runs in environment `control` and in environment `log`: .*\(the path of an inner graph names all its components\)
// The path of an inner graph names all its components.
#include <cca/deployment.hpp>

#include "parts.hpp"

struct logging : cca::graph<cca::node<"stance", stance>,
                            cca::node<"recorder", recorder>,
                            cca::wire<"stance.angles", "recorder.angles", cca::delayed<1>>> {};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"oscillator", oscillator>,
                         cca::node<"gait", gait>,
                         cca::node<"log", logging>,
                         cca::wire<"oscillator.phase", "gait.phase">> {};

struct split : cca::deployment<walk,
                               cca::environment<"control", cca::nodes<"oscillator", "gait", "log.stance">>,
#if CCA_REJECT
                               cca::environment<"log", cca::nodes<"log">>
#else
                               cca::environment<"log", cca::nodes<"log.recorder">>
#endif
                               > {
};

cca::deployed<split> d;
