// EXPECT: robot\.drives: the axis `right_hind_knee` of as_built has no drive, and no servo of its board moves it; after the bus
// LINES: 15
// A joint is missing before the board, which is no joint.
#include "oncilla_joints.hpp"

#if CCA_REJECT
struct robot : hw::oncilla<hw::memory_bus<>::end_type, a, b, c, d, e, f, g, board> {};
#else
struct robot : hw::oncilla<hw::memory_bus<>::end_type, a, b, c, d, e, f, g, h, board> {};
#endif
