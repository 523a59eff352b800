// The arm in a controller, and nothing else.
#include <cstdio>

#include "arm.hpp"

int main() {
  cca::controller<circling::simulated> c;
  c.load();
  c.start();
  c.run(cca::for_<2>{});
  const Eigen::Vector3d at = c.get<"robot.simulator">().world().end("wrist_3_link").where.at;
  std::printf("after 2 s the hand is at %.3f %.3f %.3f\n", at[0], at[1], at[2]);
}
