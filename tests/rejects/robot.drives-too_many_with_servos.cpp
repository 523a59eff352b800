// EXPECT: robot\.drives: the joint `left_front_abduction`, which is number 9 after the bus of as_built, is one too many: a servo of the board moves this axis
// LINES: 15
// A servo of the board moves each abduction, so these have no drives.
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
struct i : joint<cca::robots::oncilla::left_front_abduction, 9, 5> {};
struct robot : hw::oncilla<hw::memory_bus<>::end_type, a, b, c, d, e, f, g, h, i, board> {};
#else
struct robot : hw::oncilla<hw::memory_bus<>::end_type, a, b, c, d, e, f, g, h, board> {};
#endif
