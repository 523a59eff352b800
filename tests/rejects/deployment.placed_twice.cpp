// EXPECT: deployment\.placed_twice: `gait` \(gait\) runs in environment `control` and in environment `log`: a component runs in one environment; remove it from one of the two
// A component runs in one environment, the same in all modes. In two environments there would be two copies,
// and each would have its own state. The path of an inner graph names all its components. The nodes that no
// environment names run in one, too.
#include "two_places.hpp"

struct split : cca::deployment<walk,
                               cca::environment<"control", cca::nodes<"oscillator", "gait">>,
#if CCA_REJECT
                               cca::environment<"log", cca::nodes<"gait", "recorder">>
#else
                               cca::environment<"log", cca::nodes<"recorder">>
#endif
                               > {
};

cca::deployed<split> d;
