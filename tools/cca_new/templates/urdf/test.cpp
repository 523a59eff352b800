// The tests of the components alone and of the whole. `ctest --preset test` runs them.
//
//   my_robot_test my_robot.toml
#include <algorithm>

#include <cca/config.hpp>

#include "check.hpp"
#include "simulation.hpp"

using namespace my_robot;

namespace {

// A component is a plain struct: an input is made of a vector, the time of its data in ns, and whether it is
// fresh.
void test_follow() {
  const cca::in<"wanted", angles> there(start(), 0, true);
  const cca::in<"angles", angles> at(start(), 0, true);
  const cca::in<"wanted_velocities", velocities> rest(
      velocities::vector_type(velocities::vector_type::Zero()), 0, true);
  const cca::in<"velocities", velocities> still(velocities::vector_type(velocities::vector_type::Zero()), 0,
                                                true);
  angles::vector_type difference =
      follow().process(there, rest, at, still).vector() - cca::gravity_torques(cca::body_pose<body>(start()));
  for (Eigen::Index joint = 0; joint < difference.size(); ++joint)
    if (!has_motor(joint)) difference[joint] = 0;
  check(difference.norm() < 1e-6, "at its place a joint only carries the weight");
}

void test_all(const char* parameters) {
  cca::controller<simulated> c;
  c.load(parameters);
  put_down(c);
  c.start();
  joint_error worst;
  for (int k = 0; k < 8'000'000'000 / c.period() && c.step(); ++k)
    if (const joint_error e = worst_joint(c); e.error > worst.error) worst = e;
  std::printf("        farthest from its place: %s, by %.4f rad\n", name_of(c, worst.joint), worst.error);
  check(!c.get<"robot.simulator">().world().trouble(), "for 8 s the world is plausible");
  check(worst.error < 0.05, "each joint with a motor is at most 0.05 rad from its place");
  std::printf("        torques at the limit of a motor: %lld\n",
              static_cast<long long>(c.get<"limits">().interventions()));
}

}  // namespace

int main(int count, char** words) {
  test_follow();
  test_all(count > 1 ? words[1] : "my_robot.toml");
  return failures;
}
