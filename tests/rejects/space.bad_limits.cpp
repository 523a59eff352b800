// EXPECT: space\.bad_limits: the lower limit of (cca::)?angle of the axis toe is above its upper limit, or one of both is NaN: write the lower one first
// The limits of an axis are a range: the lower one, then the upper one.
#include "parts.hpp"

struct toe : cca::dimension<"toe"> {
#if CCA_REJECT
  static constexpr auto limits = cca::limits{cca::angle{0.5, -0.5}};
#else
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}};
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
