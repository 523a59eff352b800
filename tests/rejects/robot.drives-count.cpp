// EXPECT: robot\.drives: this robot has more or fewer drives than its body has axes
// The elbow has no drive.
#include "arm_on_drives.hpp"

struct arm : described_arm {};

#if CCA_REJECT
struct robot : cca::hardware::robot<arm, bus, upper> {};
#else
struct robot : cca::hardware::robot<arm, bus, upper, lower> {};
#endif
