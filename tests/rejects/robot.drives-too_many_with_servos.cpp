// EXPECT: robot\.drives: the joint `left_front_abduction`, which is number 9 after the bus of as_built, is one too many: a servo of the board moves this axis
// LINES: 15
// A servo of the board moves each abduction, so these have no drives.
#include "oncilla_joints.hpp"

#if CCA_REJECT
struct i : joint<cca::robots::oncilla::left_front_abduction, 9, 5> {};
struct robot : hw::oncilla<hw::memory_bus<>::end_type, a, b, c, d, e, f, g, h, i, board> {};
#else
struct robot : hw::oncilla<hw::memory_bus<>::end_type, a, b, c, d, e, f, g, h, board> {};
#endif
