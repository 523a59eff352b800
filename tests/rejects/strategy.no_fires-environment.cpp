// EXPECT: strategy\.no_fires: `posture` \(posture\) has the strategy `(cca::)?free_running`, which cannot say when it fires: it is an option of an environment
// `free_running` is an option of an environment; its components are `full_speed`.
#include <cca/deployment.hpp>

#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"stance", stance>,
#if CCA_REJECT
                         cca::node<"posture", posture, cca::free_running>,
#else
                         cca::node<"posture", posture, cca::full_speed>,
#endif
                         cca::wire<"stance.angles", "posture.angles", cca::latest>> {
};

cca::controller<walk> c;
