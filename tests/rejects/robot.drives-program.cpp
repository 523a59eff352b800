// EXPECT: robot\.drives: the axis `elbow` of arm has no drive; after the bus, list one cca::hardware::joint for each measured axis
// LINES: 16
// A program of a robot whose list of drives is refused: the sentence alone, although the program asks the
// robot for its nodes, and its graph has no port of it.
#include "arm_program.hpp"

#if CCA_REJECT
struct robot : cca::hardware::robot<arm, bus, upper> {};
#else
struct robot : cca::hardware::robot<arm, bus, upper, lower> {};
#endif

int main(int count, char** words) { return cca::robot_main<arm_program<pulled<robot>>>(count, words); }
