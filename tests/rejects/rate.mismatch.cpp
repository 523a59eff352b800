// EXPECT: rate\.mismatch: `camera\.angles` is published every 5 beats, that is at 200 Hz, but its space is camera_angles \(joint_angles over hip, knee at 100 Hz\):
// A space that states a rate gets its samples at that rate. A graph has one rate; an inner graph may state
// it, but no other.
#include "parts.hpp"

struct camera_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<100>> {};
struct camera {
  auto process(cca::beat) -> cca::out<"angles", camera_angles> { return {}; }
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
#if CCA_REJECT
                         cca::node<"camera", camera, cca::timed<5>>
#else
                         cca::node<"camera", camera, cca::timed<10>>
#endif
                         > {
};

cca::controller<walk> c;
