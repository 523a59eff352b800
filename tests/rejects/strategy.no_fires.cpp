// EXPECT: strategy\.no_fires: `stance` \(stance\) has the strategy `rate<100>`, which cannot say when it fires: use one like cca::timed<10> or cca::moderate, or
// A strategy says when a component fires. `cca::free_running` is an option of an environment; its components
// are cca::full_speed.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::node<"stance", stance, cca::rate<100>>
#else
                         cca::node<"stance", stance, cca::timed<10>>
#endif
                         > {
};

cca::controller<walk> c;
