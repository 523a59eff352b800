// A small graph with a resource node, a limiter, two rates and elementary functions, for `calls.py` to
// disassemble.
#include <cmath>
#include <numbers>

#include <cca/cca.hpp>

namespace small {

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}, cca::velocity{-5.0, 5.0}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}};
};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};
struct amplitude : cca::space<cca::amplitude, cca::axes<cca::x>, cca::rate<100>> {};
struct phase : cca::space<cca::phase, cca::axes<cca::x>> {};

struct robot {
  Eigen::Vector2d at{0, -1};
  auto sense() -> cca::out<"angles", leg_angles> { return at; }
  void act(cca::in<"command", leg_angles> to) { at += 0.1 * (to.vector() - at); }
};
struct posture {
  auto process(cca::in<"angles", leg_angles> angles) -> cca::out<"amplitude", amplitude> {
    return 1 + 0.1 * angles[hip{}];
  }
};
struct oscillator {
  double turned = 0;
  auto process(cca::in<"amplitude", amplitude> radius, cca::beat now) -> cca::out<"phase", phase> {
    turned =
        cca::math::fmod(turned + 2 * std::numbers::pi * radius[cca::x{}] * now.dt(), 2 * std::numbers::pi);
    return turned;
  }
};
struct gait {
  auto process(cca::in<"phase", phase> p) -> cca::out<"angles", leg_angles> {
    return Eigen::Vector2d(0.3 * cca::math::sin(p[cca::x{}]), -1 + 0.3 * cca::math::cos(p[cca::x{}]));
  }
};

struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"posture", posture, cca::timed<10>>,
                         cca::node<"cpg", oscillator, cca::timed<1>>,
                         cca::node<"gait", gait>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::node<"robot", robot>,
                         cca::wire<"robot.angles", "posture.angles", cca::latest>,
                         cca::wire<"posture.amplitude", "cpg.amplitude", cca::latest>,
                         cca::wire<"cpg.phase", "gait.phase">,
                         cca::wire<"gait.angles", "limits.command">,
                         cca::wire<"limits.safe", "robot.command">> {};

}  // namespace small

void beat(cca::controller<small::walk>& c) { c.step(); }
