// The tests of the components alone and of the whole. `ctest --preset test` runs them.
//
//   my_robot_test my_robot.toml
#include <algorithm>
#include <cmath>

#include <cca/config.hpp>

#include "check.hpp"
#include "simulation.hpp"

using namespace my_robot;

namespace {

// A component is a plain struct: an input is made of a vector, the time of its data in ns, and whether it is
// fresh.
void test_balance() {
  const cca::in<"place", cart_place> middle(cart_place::vector_type(0.0), 0, true);
  const cca::in<"velocities", velocities> still(velocities::vector_type(0, 0), 0, true);
  const auto force = [&](double at, double tilt) {
    const cca::in<"angles", angles> now(angles::vector_type(at, tilt), 0, true);
    return balance().process(middle, now, still)[cart{}];
  };
  check(force(0, 0) == 0, "upright in the middle it does nothing");
  check(force(0, 0.1) > 1, "the cart runs under a pole that leans forward");
  check(force(0, -0.1) < -1, "and backward");
}

void test_all(const char* parameters) {
  cca::controller<simulated> c;
  c.load(parameters);
  c.start();
  const auto& world = c.get<"robot.simulator">().world();
  const auto run = [&](double seconds) {
    double widest = 0;
    for (int k = 0; k < 1000 * seconds && c.step(); ++k)
      widest = std::max(widest, std::abs(world.joint("pole").angle));
    return widest;
  };
  check(run(4) < 0.5, "the pole stays up");
  check(std::abs(world.joint("cart").angle - 0.3) < 0.03, "the cart reaches its place in 4 s");
  check(run(4) < 0.5 && std::abs(world.joint("cart").angle + 0.3) < 0.03, "and the other one");

  c.get<"robot.simulator">().world().pull("pole", {1, 0, 0});  // N, at the end of the pole
  run(0.1);
  c.get<"robot.simulator">().world().pull("pole", {0, 0, 0});
  check(run(8) < 0.7, "a push does not make it fall");
  check(c.get<"limits">().interventions() == 0, "the motor is strong enough");
}

}  // namespace

int main(int count, char** words) {
  test_balance();
  test_all(count > 1 ? words[1] : "my_robot.toml");
  return failures;
}
