// Tutorial, step 3: tests a component alone, without a graph or a controller. docs/tutorial/3_component.md
#include <cstdio>

#include "impedance.hpp"

// [test]
int failures = 0;
void check(bool holds, const char* what) {
  std::printf("%s  %s\n", holds ? "ok    " : "FAILED", what);
  failures += !holds;
}

int main() {
  using Eigen::Vector2d;
  // An input is made of a vector, the time of origin in ns, and whether it is fresh.
  const cca::in<"target", leg_target> target(Vector2d(0.1, -0.5), 0, true);
  const cca::in<"angles", leg_angles> there(Vector2d(0.1, -0.5), 0, true);
  const cca::in<"angles", leg_angles> behind(Vector2d(0.0, -0.5), 0, true);
  const cca::in<"velocities", leg_velocities> still(Vector2d(0, 0), 0, true);
  const cca::in<"velocities", leg_velocities> moving(Vector2d(2, 0), 0, true);

  impedance c;
  check(c.process(target, there, still).vector() == Vector2d(0, 0), "at the target it draws no current");
  check(c.process(target, behind, still)[hip{}] == 2.0, "0.1 rad behind it draws 2 A at 20 A/rad");
  check(c.process(target, there, moving)[hip{}] == -2.0, "it brakes 2 rad/s with 2 A");

  try {
    cca::check_parameters(impedance::parameters{200.0, 1.0});
    check(false, "a stiffness of 200 A/rad is refused");
  } catch (const cca::refused& refusal) {
    check(true, "a stiffness of 200 A/rad is refused:");
    std::printf("        %s\n", refusal.what());
  }
  return failures;
}
// [test end]
