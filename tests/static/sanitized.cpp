// Under -fsanitize=undefined g++ refuses comparisons of addresses in constants, and so whatever plans by them
// (docs/compilers.md). A graph, a set of modes and a deployment compile with it.
#include <cca/cca.hpp>
#include <cca/deployment.hpp>
#include <cca/modes.hpp>

namespace sanitized {

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

struct rest : cca::graph<cca::node<"rest", damped>,
                         cca::node<"limits", cca::limiter<hip_angle>>,
                         cca::node<"joint", joint>,
                         cca::wire<"joint.angle", "rest.angle", cca::delayed<1>>,
                         cca::wire<"rest.angle", "limits.command">,
                         cca::wire<"limits.safe", "joint.command", cca::delayed<1>>> {};
struct move : cca::graph<cca::node<"move", shifted>,
                         cca::node<"limits", cca::limiter<hip_angle>>,
                         cca::node<"joint", joint>,
                         cca::wire<"joint.angle", "move.angle", cca::delayed<1>>,
                         cca::wire<"move.angle", "limits.command">,
                         cca::wire<"limits.safe", "joint.command", cca::delayed<1>>> {};
struct both : cca::modes<cca::mode<"rest", rest>, cca::mode<"move", move>> {};
struct split : cca::deployment<rest,
                               cca::environment<"robot", cca::nodes<"joint">>,
                               cca::environment<"mind", cca::other_nodes>> {};

}  // namespace sanitized

static_assert(cca::well_formed<sanitized::both>);
static_assert(cca::well_formed<sanitized::split>);

bool beat_once(cca::controller<sanitized::rest>& c) { return c.step(); }
bool beat_once(cca::controller<sanitized::both>& c) { return c.switch_to<"move">(), c.step(); }
bool beat_once(cca::deployed<sanitized::split>& c) { return c.step(); }
