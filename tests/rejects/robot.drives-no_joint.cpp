// EXPECT: robot\.drives: board, which is number 1 after the bus of arm, is no cca::hardware::joint: list all joints, or one
// LINES: 15
// The board comes after the joints.
#include "arm_on_drives.hpp"

struct arm : described_arm {};
struct board : cca::hardware::load_board<0x100, 1, 1> {};

#if CCA_REJECT
struct robot : cca::hardware::robot<arm, bus, board, upper, lower> {};
#else
struct robot : cca::hardware::robot<arm, bus, upper, lower, board> {};
#endif
