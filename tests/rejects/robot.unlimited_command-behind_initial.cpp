// EXPECT: robot\.unlimited_command: `split\.angles` may be read before a first command has passed a limiter, and would then hold the cca::initial of its wire, which lies outside of the limits of `knee`, on its way to the actuator `drive\.command`
// The same holds for the wires between a limiter and the actuator.
#include "parts.hpp"

struct drive {
  void act(cca::in<"command", cca::sub_space<leg_angles, knee>>) {}
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"log", logbook>,
                         cca::node<"stance", stance, cca::timed<10, 9>>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::node<"split", cca::splitter<"angles", leg_angles>, cca::timed<1>>,
                         cca::node<"drive", drive>,
                         cca::wire<"stance.angles", "limits.command">,
#if CCA_REJECT
                         cca::wire<"limits.safe", "split.angles", cca::latest, cca::initial<0.2, 0.3>>,
#else
                         cca::wire<"limits.safe", "split.angles", cca::latest, cca::initial<0.2, -0.3>>,
#endif
                         cca::wire<"split.knee", "drive.command">> {
};

cca::controller<walk> c;
