// Tutorial, step 8: a quadruped in the simulator crouches. docs/tutorial/8_simulator.md
#include <cstdio>

#include "crouch.hpp"

// [program]
struct crouching_in_simulator : crouching<cca::sim::oncilla> {};

int main() {
  cca::controller<crouching_in_simulator> c;
  c.load();
  c.start();
  const cca::sim::world& world = c.get<"robot.simulator">().world();
  for (int i = 1; i <= 4; ++i) {
    c.run(cca::for_<0.5>{});
    std::printf("%.1f s  trunk %.0f mm above the ground%s\n", 0.5 * i, 1000 * world.trunk_position()[2],
                world.fallen() ? ", fallen" : "");
  }

  cca::controller<crouching_in_simulator> copy = c;  // a snapshot, with the physics
  c.run(cca::for_<1>{});
  copy.run(cca::for_<1>{});
  const bool same = world.trunk_position()[2] == copy.get<"robot.simulator">().world().trunk_position()[2];
  std::printf("the copy does %s\n", same ? "the same, bit for bit" : "something else");
}
// [program end]
