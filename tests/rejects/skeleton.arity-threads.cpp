// EXPECT: skeleton\.arity: `plan` \(farm_on_threads<.*>\) is to have pipeline<posture, posture> on threads, but that is a graph, whose nodes run in the loop: put what it does into one component
// A graph belongs to the loop, so it cannot be a worker on a thread.
#include <cca/skeleton/farm_on_threads.hpp>

#include "parts.hpp"

using legs = cca::array_of<leg_angles, 2>;
struct posture_twice {
  auto process(cca::in<"angles", leg_angles> angles) -> cca::out<"angles", leg_angles> { return angles; }
};
#if CCA_REJECT
using worker = cca::pipeline<posture, posture>;
#else
using worker = posture_twice;
#endif

struct all_legs {
  auto process(cca::beat) -> cca::out<"angles", legs> { return {}; }
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"legs", all_legs>,
                         cca::node<"plan", cca::farm_on_threads<worker, legs, legs>>,
                         cca::wire<"legs.angles", "plan.input">> {};

cca::controller<walk> c;
