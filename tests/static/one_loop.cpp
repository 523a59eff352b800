// The graph whose loop docs/how_it_becomes_one_loop.md shows.
#include <cca/cca.hpp>

// [one loop]
struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}};
};
struct hip_angle : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};

struct joint {
  auto sense() -> cca::out<"angle", hip_angle> { return angle; }
  void act(cca::in<"command", hip_angle> to) { angle = to[hip{}]; }
  double angle = 0.1;
};
struct damped {
  auto process(cca::in<"angle", hip_angle> q) -> cca::out<"angle", hip_angle> { return 0.75 * q[hip{}]; }
};
struct shifted {
  auto process(cca::in<"angle", hip_angle> q) -> cca::out<"angle", hip_angle> { return q[hip{}] + 0.25; }
};

struct three : cca::graph<cca::node<"shift", shifted>,  // declared first, but reads the output of `damp`
                          cca::node<"damp", damped>,
                          cca::node<"limits", cca::limiter<hip_angle>>,
                          cca::node<"joint", joint>,
                          cca::wire<"joint.angle", "damp.angle">,
                          cca::wire<"damp.angle", "shift.angle">,
                          cca::wire<"shift.angle", "limits.command">,
                          cca::wire<"limits.safe", "joint.command">> {};

bool beat(cca::controller<three>& c) { return c.step(); }
// [one loop end]
