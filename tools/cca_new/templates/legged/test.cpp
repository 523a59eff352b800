// The tests of the components alone and of the whole. `ctest --preset test` runs them.
//
//   my_robot_test my_robot.toml
#include <cca/config.hpp>

#include "check.hpp"
#include "simulation.hpp"

using namespace my_robot;

namespace {

// A component is a plain struct: an input is made of a vector, the time of its data in ns, and whether it is
// fresh.
void test_gait() {
  const auto hip = [](double size, double turn, Eigen::Index leg) {
    const cca::in<"phase", step_phase> landing(step_phase::vector_type(0.0), 0, true);
    const cca::in<"size", step_size> of(step_size::vector_type(size), 0, true);
    const cca::in<"turn", turning> to(turning::vector_type(turn), 0, true);
    return gait().process(landing, of, to).vector()[3 * leg + 1];
  };
  const gait::parameters p = gait().p;
  check(hip(0, 0, 0) == p.front.hip, "without steps the legs stand");
  check(std::abs(hip(1, 0, 0) - p.front.hip - p.front.swing) < 1e-12, "a foot lands foremost");
  check(hip(1, 0.2, 0) < hip(1, 0, 0), "to turn left, the left legs swing less");
}

void test_all(const char* parameters) {
  cca::controller<simulated> c;
  c.load(parameters);
  put_down(c);
  c.start();
  const auto& world = c.get<"robot.simulator">().world();
  const auto run = [&](double seconds) {
    for (int k = 0; k < 1000 * seconds && !has_fallen(c) && c.step(); ++k) continue;
  };
  run(2);
  const double begun_at = world.frame(-1).where.at[0];
  run(8);
  const auto at = world.frame(-1).where.at;
  std::printf("        %.2f m/s, %.2f m aside\n", (at[0] - begun_at) / 8, at[1]);
  check(!has_fallen(c), "it does not fall in 10 s");
  check((at[0] - begun_at) / 8 > 0.3, "it is faster than 0.3 m/s");
  check(std::abs(at[1]) < 0.3, "and less than 0.3 m aside");
}

}  // namespace

int main(int count, char** words) {
  test_gait();
  test_all(count > 1 ? words[1] : "my_robot.toml");
  return failures;
}
