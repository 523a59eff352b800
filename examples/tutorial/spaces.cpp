// Tutorial, step 2: samples of the leg's spaces, without a graph. docs/tutorial/2_spaces.md
#include <cstdio>

#include "leg_spaces.hpp"

int main() {
  // [samples]
  const cca::sample<leg_angles> wish(Eigen::Vector2d(1.2, -0.6));  // hip, knee
  std::printf("wish: hip %.2f rad, %s\n", wish[hip{}],
              wish.within_limits() ? "within limits" : "out of limits");
  const auto safe = wish.clamped();  // another sample of leg_angles
  std::printf("safe: hip %.2f rad, knee %.2f rad\n", safe[hip{}], safe[knee{}]);

  const cca::sample<leg_currents> currents(Eigen::Vector2d(4, -3));
  std::printf("heat at 0.2 ohm: %.1f W\n", currents.heat(0.2));
  std::printf("the knee alone: %.1f A\n", currents.on<knee>()[knee{}]);
  // [samples end]
}
