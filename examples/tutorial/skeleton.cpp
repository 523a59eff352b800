// Tutorial, step 6: two legs from one skeleton. docs/tutorial/6_skeleton.md
#include <cstdio>

#include <cca/base/math.hpp>

#include "controlled_leg.hpp"
#include "impedance.hpp"

// [two legs]
// Both feet to the front and back, against each other.
struct stride {
  auto process(cca::beat now) -> std::tuple<cca::out<"left", leg_target>, cca::out<"right", leg_target>> {
    const double swing = 0.3 * cca::math::sin(3e-9 * static_cast<double>(now.time()));
    return {Eigen::Vector2d(swing, -0.5), Eigen::Vector2d(-swing, -0.5)};
  }
};

struct left_leg : controlled_leg<impedance> {};
struct right_leg : controlled_leg<impedance> {};

struct biped : cca::graph<cca::rate<1000>,
                          cca::node<"stride", stride, cca::timed<10>>,
                          cca::node<"left", left_leg>,
                          cca::node<"right", right_leg>,
                          cca::wire<"stride.left", "left.target", cca::latest>,
                          cca::wire<"stride.right", "right.target", cca::latest>> {};

int main() {
  cca::controller<biped> c;
  c.set<"right.controller">({60.0, 2.0});  // parameters of a component in an inner graph
  c.load();
  c.start();
  for (int i = 1; i <= 4; ++i) {
    c.run(cca::for_<0.5>{});
    std::printf("%.1f s  hips: left %6.3f rad, right %6.3f rad\n", 0.5 * i, c.get<"left.leg">().angles[0],
                c.get<"right.leg">().angles[0]);
  }
}
// [two legs end]
