// EXPECT: robot\.drives: the body of arm has 2 axes that are measured \(shoulder, elbow\), and 1 drive or board follows the bus, none for `elbow`
// The elbow has no drive.
#include "arm_on_drives.hpp"

struct arm : described_arm {};

#if CCA_REJECT
struct robot : cca::hardware::robot<arm, bus, upper> {};
#else
struct robot : cca::hardware::robot<arm, bus, upper, lower> {};
#endif
