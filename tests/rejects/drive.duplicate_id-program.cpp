// EXPECT: drive\.duplicate_id: on the bus `0` the drives 1 \(shoulder\) and 2 \(elbow\) both use the id 0x301
// LINES: 30
// A program of a robot whose drives can't share their bus: the sentence alone.
#include "arm_program.hpp"

#if CCA_REJECT
struct second : driven<elbow, 1> {};
#else
struct second : driven<elbow, 2> {};
#endif
struct robot : cca::hardware::robot<arm, bus, upper, second> {};

int main(int count, char** words) { return cca::robot_main<arm_program<pulled<robot>>>(count, words); }
