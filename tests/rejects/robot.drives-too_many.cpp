// EXPECT: robot\.drives: the joint `elbow`, which is number 3 after the bus of arm, is one too many: a joint before it moves this axis; leave it out
// LINES: 15
// The elbow has two drives.
#include "arm_on_drives.hpp"

struct arm : described_arm {};
struct second : driven<elbow, 3> {};

#if CCA_REJECT
struct robot : cca::hardware::robot<arm, bus, upper, lower, second> {};
#else
struct robot : cca::hardware::robot<arm, bus, upper, lower> {};
#endif
