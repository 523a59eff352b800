// EXPECT: robot\.drives: the axis `elbow` of arm has no drive; after the bus, list one cca::hardware::joint for each measured axis
// LINES: 15
// The same with the joints as a list.
#include "arm_on_drives.hpp"

struct arm : described_arm {};

#if CCA_REJECT
using joints = cca::hardware::joint_list<upper>;
#else
using joints = cca::hardware::joint_list<upper, lower>;
#endif

struct robot : cca::hardware::robot<arm, bus, joints> {};
