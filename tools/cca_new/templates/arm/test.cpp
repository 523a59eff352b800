// The tests of the components alone and of the whole. `ctest --preset test` runs them.
//
//   my_robot_test my_robot.toml
#include <algorithm>

#include <cca/config.hpp>

#include "check.hpp"
#include "simulation.hpp"

using namespace my_robot;

namespace {

// A component is a plain struct: made, called, compared. A beat is made of its number, the ns of a beat, and
// how many beats ago the component last fired.
void test_circle() {
  circle way;
  const auto at = [&](std::int64_t beat) {
    const auto [pose, motion] = way.process(cca::beat(beat, 1'000'000, 1));
    return Eigen::Vector3d(pose.vector().head<3>());
  };
  check((at(0) - way.start.at).norm() < 1e-12, "the circle begins where the arm starts");
  check((at(8000) - at(4000)).norm() < 1e-9, "a turn takes 4 s");
  check(std::abs((at(6000) - at(4000)).norm() - 0.2) < 1e-9, "it is 0.2 m wide");
}

void test_all(const char* parameters) {
  cca::controller<simulated> c;
  c.load(parameters);
  put_down(c);
  c.start();
  const auto run = [&](double seconds) {
    double most = 0;
    for (int k = 0; k < 1000 * seconds && c.step(); ++k) most = std::max(most, error_of(c));
    return most;
  };
  check(run(8) < 0.01, "the hand is never more than 10 mm from its way");

  c.get<"robot.simulator">().world().pull("arm", {16, 0, 0});  // N
  run(1);
  const double given_way = error_of(c);
  check(given_way > 0.01 && given_way < 0.04, "it gives way to a push, by about 20 mm for 16 N at 800 N/m");
  c.get<"robot.simulator">().world().pull("arm", {0, 0, 0});
  run(1);
  check(error_of(c) < 0.01, "and comes back");
  check(c.get<"limits">().interventions() == 0, "no motor is at its limit");
}

}  // namespace

int main(int count, char** words) {
  test_circle();
  test_all(count > 1 ? words[1] : "my_robot.toml");
  return failures;
}
