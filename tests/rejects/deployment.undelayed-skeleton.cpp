// EXPECT: deployment\.undelayed: `legs\.split\.part1` is published in environment `body` and read in environment `mind`, so it takes at least a beat to get there: add cca::inner_wires<cca::delayed<1>> to the arguments of the skeleton `legs` \(farm<
// The wires inside a skeleton are not the user's, so an option of the skeleton sets their policies.
#include <cca/deployment.hpp>

#include "parts.hpp"

using two_legs = cca::array_of<leg_angles, 2>;

#if CCA_REJECT
using crew = cca::farm<posture, two_legs, two_legs>;
#else
using crew = cca::farm<posture, two_legs, two_legs, cca::inner_wires<cca::delayed<1>>>;
#endif
struct stances {
  auto process(cca::beat) -> cca::out<"angles", two_legs> { return {}; }
};
struct both_legs {
  void process(cca::in<"angles", two_legs>) {}
};
struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"stances", stances>,
                         cca::node<"legs", crew>,
                         cca::node<"robot", both_legs>,
                         cca::wire<"stances.angles", "legs.input">,
                         cca::wire<"legs.output", "robot.angles">> {};

struct split : cca::deployment<walk,
                               cca::environment<"body", cca::other_nodes>,
                               cca::environment<"mind", cca::nodes<"legs.worker1">>> {};

cca::deployed<split> d;
