// EXPECT: strategy\.misplaced: `leg` \(leg\) is a resource node, which runs at fixed beats: it may be cca::timed, cca::full_speed or cca::inactive
// A resource node begins and ends beats, so it cannot wait for its inputs. Nor can it be in a graph that is
// stopped: a robot that is not commanded any more would go on with its last command. A graph does not fire,
// its components do; as a whole it can be cca::stoppable<>.
#include "parts.hpp"

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"stance", stance>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
#if CCA_REJECT
                         cca::node<"leg", leg, cca::moderate>,
#else
                         cca::node<"leg", leg, cca::timed<2>>,
#endif
                         cca::wire<"stance.angles", "limits.command">,
                         cca::wire<"limits.safe", "leg.command", cca::latest>> {
};

cca::controller<walk> c;
