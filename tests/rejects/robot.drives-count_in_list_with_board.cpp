// EXPECT: robot\.drives: the axis `left_front_hip` \(and 1 more\) of as_built has no drive, and no servo of its board moves it; after the bus
// LINES: 15
// Two joints are missing in the list before the board.
#include "oncilla.hpp"

struct a : joint<sim::left_front_hip, 1, 0> {};
struct b : joint<sim::right_front_hip, 2, 2> {};
struct c : joint<sim::left_hind_hip, 3, 1> {};
struct d : joint<sim::right_hind_hip, 4, 3> {};
struct e : joint<sim::left_front_knee, 5, 0> {};
struct f : joint<sim::right_front_knee, 6, 2> {};
struct g : joint<sim::left_hind_knee, 7, 1> {};
struct h : joint<sim::right_hind_knee, 8, 3> {};

#if CCA_REJECT
using joints = hw::joint_list<b, c, d, e, f, g>;
#else
using joints = hw::joint_list<a, b, c, d, e, f, g, h>;
#endif

struct robot : hw::oncilla<hw::memory_bus<>::end_type, joints, board> {};
