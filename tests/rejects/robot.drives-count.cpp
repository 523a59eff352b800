// EXPECT: robot\.drives: the axis `elbow` of arm has no drive; after the bus, list one cca::hardware::joint for each measured axis
// LINES: 15
// The elbow has no drive.
#include "arm_on_drives.hpp"

struct arm : described_arm {};

#if CCA_REJECT
struct robot : cca::hardware::robot<arm, bus, upper> {};
#else
struct robot : cca::hardware::robot<arm, bus, upper, lower> {};
#endif
