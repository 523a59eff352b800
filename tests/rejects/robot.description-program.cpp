// EXPECT: robot\.description: other lacks `drives`: the description of a robot states `body`
// LINES: 16
// A program of a robot on drives whose description is refused: the sentence alone.
#include "arm_program.hpp"

struct other {
  using body = arm_body;
  using rate = cca::rate<1000>;
  using commands = cca::robots::commands<cca::robots::torque_command>;
#if !CCA_REJECT
  static constexpr std::array<cca::robots::joint_drive, 2> drives{};
#endif
};
struct robot : cca::hardware::robot<other, bus, upper, lower> {};

int main(int count, char** words) { return cca::robot_main<arm_program<pulled<robot>>>(count, words); }
