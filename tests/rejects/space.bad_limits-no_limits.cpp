// EXPECT: space\.bad_limits: `limits` of the axis toe is `angle`, and no cca::limits: list the ranges in one, as in `static constexpr auto limits = cca::limits\{cca::angle\{-0\.5, 0\.5\}\};`
// LINES: 15
// What an axis calls `limits` is a cca::limits, also where it has one range only.
#include <cca/cca.hpp>

// Refused where a space lists the axis, without a graph.

struct toe : cca::dimension<"toe"> {
#if CCA_REJECT
  static constexpr auto limits = cca::angle{-0.5, 0.5};
#else
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}};
#endif
};
struct toe_angle : cca::space<cca::joint_angles, cca::axes<toe>, cca::rate<1000>> {};

struct lift {
  auto process(cca::beat) -> cca::out<"angle", toe_angle> { return 0.1; }
};
struct toe_motor {
  void act(cca::in<"command", toe_angle>) {}
};
struct walk : cca::graph<cca::node<"lift", lift>,
                         cca::node<"limits", cca::limiter<toe_angle>>,
                         cca::node<"motor", toe_motor>,
                         cca::wire<"lift.angle", "limits.command">,
                         cca::wire<"limits.safe", "motor.command">> {};

cca::controller<walk> c;
