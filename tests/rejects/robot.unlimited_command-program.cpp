// EXPECT: robot\.unlimited_command: `robot\.torque\.shoulder` reaches the actuator `robot\.shoulder\.torque` without passing a limiter
// LINES: 25
// A program of a robot on drives whose graph breaks a rule: the sentence alone, although the program asks for
// the nodes of the robot.
#include "arm_program.hpp"

struct robot : cca::hardware::robot<arm, bus, upper, lower> {};

struct unlimited : cca::graph<cca::node<"pull", pull>,
                              cca::node<"robot", robot>,
                              cca::wire<"pull.torques", "robot.torque">> {};
#if CCA_REJECT
struct program : arm_program<unlimited> {};
#else
struct program : arm_program<pulled<robot>> {};
#endif

int main(int count, char** words) { return cca::robot_main<program>(count, words); }
