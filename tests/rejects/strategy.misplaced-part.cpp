// EXPECT: strategy\.misplaced: `body\.leg` \(leg\) is a resource node, which stops only with its controller, but the graph around it is cca::stoppable<>: move the resource node out of that graph
// A robot that is not commanded any more would go on with its last command.
#include "parts.hpp"

struct body : cca::graph<cca::node<"stance", stance>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::node<"leg", leg>,
                         cca::wire<"stance.angles", "limits.command">,
                         cca::wire<"limits.safe", "leg.command">> {};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::node<"body", body, cca::stoppable<>>
#else
                         cca::node<"body", body>
#endif
                         > {
};

cca::controller<walk> c;
