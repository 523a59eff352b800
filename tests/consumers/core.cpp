// A user's program: a controller moves one joint through a limiter.
#include <cca/cca.hpp>

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}};
};
struct hip_angle : cca::space<cca::joint_angles, cca::axes<hip>, cca::rate<1000>> {};

struct goal {
  auto process(cca::beat) -> cca::out<"angle", hip_angle> { return 2.0; }
};
struct joint {
  void act(cca::in<"command", hip_angle> to) { at = to[hip{}]; }
  double at = 0;
};
struct moving : cca::graph<cca::node<"goal", goal>,
                           cca::node<"limits", cca::limiter<hip_angle>>,
                           cca::node<"joint", joint>,
                           cca::wire<"goal.angle", "limits.command">,
                           cca::wire<"limits.safe", "joint.command">> {};

int main() {
  cca::controller<moving> c;
  c.load();
  c.start();
  c.run(cca::for_beats<10>{});
  return c.get<"joint">().at == 0.5 ? 0 : 1;
}
