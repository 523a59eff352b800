// EXPECT: space\.mismatch: `source\.y` publishes leg_angles \(joint_angles over hip, knee\) but `target\.x` expects expected \(joint_torques over hip, knee\): the
// Angles are no torques, although both are two numbers.
#include "parts.hpp"

struct source {
  auto process(cca::beat) -> cca::out<"y", leg_angles> { return {}; }
};
#if CCA_REJECT
struct expected : cca::space<cca::joint_torques, cca::axes<hip, knee>> {};
#else
struct expected : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
#endif
struct target {
  void process(cca::in<"x", expected>) {}
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"source", source>,
                         cca::node<"target", target>,
                         cca::wire<"source.y", "target.x">> {};

cca::controller<walk> c;
