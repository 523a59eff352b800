// EXPECT: space\.missing_limits: `limits\.command` takes commands of toe_angle, but its axis `toe` states no limits of angle to keep them within: add `static
// Commands to an actuator are kept within limits, and the axes state these. The angle of a continuous axis
// has no limits of its own: a command along it is bounded by its velocity.
#include "parts.hpp"

#if CCA_REJECT
struct toe : cca::dimension<"toe"> {};
#else
struct toe : cca::dimension<"toe"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}};
};
#endif
struct toe_angle : cca::space<cca::joint_angles, cca::axes<toe>> {};

struct lift {
  auto process(cca::beat) -> cca::out<"angle", toe_angle> { return 0.1; }
};
struct toe_motor {
  void act(cca::in<"command", toe_angle>) {}
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"lift", lift>,
                         cca::node<"limits", cca::limiter<toe_angle>>,
                         cca::node<"motor", toe_motor>,
                         cca::wire<"lift.angle", "limits.command">,
                         cca::wire<"limits.safe", "motor.command">> {};

cca::controller<walk> c;
