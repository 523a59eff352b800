// EXPECT: space\.mismatch: `limits\.safe` publishes leg_angles \(joint_angles over hip, knee at 1000 Hz\) but `leg\.command` expects foot_angles \(joint_angles over
// A wire joins two ports of one space: domain type with its frame, axes in their order, rate. Angles are no
// torques, although both are two numbers. A rate that only one end states does not count. A guard on the
// wrong side of an emergency stop breaks this rule too: before it a set point carries the rule that it
// breaks, after it what the drive may do. The README quotes this message.
#include <cca/cca.hpp>

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}};
};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
struct foot_angles : cca::space<cca::joint_angles, cca::axes<knee, hip>, cca::rate<1000>> {};

#if CCA_REJECT
using expected = foot_angles;
#else
using expected = leg_angles;
#endif

struct swing {
  auto process(cca::beat) -> cca::out<"angles", leg_angles> { return {}; }
};
struct leg {
  void act(cca::in<"command", expected>) {}
};
struct swinging : cca::graph<cca::node<"swing", swing>,
                             cca::node<"limits", cca::limiter<leg_angles>>,
                             cca::node<"leg", leg>,
                             cca::wire<"swing.angles", "limits.command">,
                             cca::wire<"limits.safe", "leg.command">> {};

cca::controller<swinging> c;
