// EXPECT: space\.bad_limits: the axis toe is continuous and states limits of angle, which a joint that turns without end lacks
// A continuous axis has limits of velocity instead.
#include "parts.hpp"

struct toe : cca::dimension<"toe"> {
  static constexpr bool continuous = true;
#if CCA_REJECT
  static constexpr auto limits = cca::limits{cca::angle{-3, 3}, cca::velocity{-5, 5}};
#else
  static constexpr auto limits = cca::limits{cca::velocity{-5, 5}};
#endif
};
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
