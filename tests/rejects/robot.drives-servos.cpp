// EXPECT: robot\.drives: the axis `right_hind_knee` of as_built has no drive, and no servo of its board moves it
// LINES: 15
// The board of an Oncilla moves its abductions; here the right hind knee has no drive, and a hip has two.
#include "oncilla_joints.hpp"

#if CCA_REJECT
struct another_hip : joint<sim::right_hind_hip, 8, 3> {};
struct robot : hw::oncilla<hw::memory_bus<>::end_type, a, b, c, d, e, f, g, another_hip, board> {};
#else
struct robot : hw::oncilla<hw::memory_bus<>::end_type, a, b, c, d, e, f, g, h, board> {};
#endif
