// EXPECT: space\.mismatch: `source\.y` publishes fast_angles \(joint_angles over hip, knee at 1000 Hz\) but `target\.x` expects expected \(joint_angles over hip,
// Two stated rates agree; a rate that only one end states does not count.
#include "parts.hpp"

struct fast_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};

struct source {
  auto process(cca::beat) -> cca::out<"y", fast_angles> { return {}; }
};
#if CCA_REJECT
struct expected : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<500>> {};
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
