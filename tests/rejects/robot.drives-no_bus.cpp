// EXPECT: robot\.drives: upper, which stands before the joints of arm, is no CAN bus: write the type of its buses there, as in cca::hardware::robot<arm, cca::hardware::socket_can, \.\.\.>
// LINES: 16
// The type of the buses is left out, in a program.
#include "arm_program.hpp"

#if CCA_REJECT
struct robot : cca::hardware::robot<arm, upper, lower> {};
#else
struct robot : cca::hardware::robot<arm, bus, upper, lower> {};
#endif

int main(int count, char** words) { return cca::robot_main<arm_program<pulled<robot>>>(count, words); }
