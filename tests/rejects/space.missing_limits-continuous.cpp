// EXPECT: space\.missing_limits: `limits\.command` takes commands of wheel_angle, but its axis `wheel` states no limits of velocity to keep them within
// The angle of a continuous axis has no limits of its own: a command along it is bounded by its velocity.
#include "parts.hpp"

struct wheel : cca::dimension<"wheel"> {
  static constexpr bool continuous = true;
#if CCA_REJECT
#else
  static constexpr auto limits = cca::limits{cca::velocity{-9, 9}};
#endif
};
struct wheel_angle : cca::space<cca::joint_angles, cca::axes<wheel>> {};

struct roll {
  auto process(cca::beat) -> cca::out<"angle", wheel_angle> { return 0.1; }
};
struct wheel_motor {
  void act(cca::in<"command", wheel_angle>) {}
};

struct drive : cca::graph<cca::rate<1000>,
                          cca::node<"roll", roll>,
                          cca::node<"limits", cca::limiter<wheel_angle>>,
                          cca::node<"motor", wheel_motor>,
                          cca::wire<"roll.angle", "limits.command">,
                          cca::wire<"limits.safe", "motor.command">> {};

cca::controller<drive> c;
