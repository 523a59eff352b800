// EXPECT: robot\.drives: the axis `left_front_hip` \(and 1 more\) of as_built has no drive, and no servo of its board moves it; after the bus
// LINES: 15
// Two joints are missing in the list before the board.
#include "oncilla_joints.hpp"

#if CCA_REJECT
using joints = hw::joint_list<b, c, d, e, f, g>;
#else
using joints = hw::joint_list<a, b, c, d, e, f, g, h>;
#endif

struct robot : hw::oncilla<hw::memory_bus<>::end_type, joints, board> {};
