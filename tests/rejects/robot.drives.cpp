// EXPECT: robot\.drives: the joints of arm are not in the order of the axes of its body: drive 1 after the bus is that of `elbow`, and that axis of the body is `shoulder`
// Each joint knows its axis; the order says which drive is which for a reader, too.
#include "arm_on_drives.hpp"

struct arm : described_arm {};

#if CCA_REJECT
struct robot : cca::hardware::robot<arm, bus, lower, upper> {};
#else
struct robot : cca::hardware::robot<arm, bus, upper, lower> {};
#endif
