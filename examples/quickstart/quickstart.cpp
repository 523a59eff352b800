// The README's example: a leg that is commanded to swing farther than its hip can, and a limiter.
#include <cstdio>

// [quickstart]
#include <cca/cca.hpp>

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}};
};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};

struct swing {
  auto process(cca::beat now) -> cca::out<"angles", leg_angles> {
    const double angle = 6e-9 * static_cast<double>(now.time());
    return leg_angles::vector_type{0.7 * cca::math::sin(angle), 0.4 * cca::math::cos(angle) - 0.9};
  }
};

struct leg {  // stands for a robot: it reaches each command at once
  auto sense() -> cca::out<"angles", leg_angles> { return at; }
  void act(cca::in<"command", leg_angles> to) { at = to.vector(); }
  leg_angles::vector_type at{0, -0.9};
};

struct swinging : cca::graph<cca::node<"swing", swing>,
                             cca::node<"limits", cca::limiter<leg_angles>>,
                             cca::node<"leg", leg>,
                             cca::wire<"swing.angles", "limits.command">,
                             cca::wire<"limits.safe", "leg.command">> {};

int main() {
  cca::controller<swinging> c;
  c.load();
  c.start();
  c.run(cca::for_beats<250>{});
  std::printf("hip %.3f rad, knee %.3f rad\n", c.get<"leg">().at[0], c.get<"leg">().at[1]);
}
// [quickstart end]
