// EXPECT: robot\.drives: the rate of arm is 100 Hz, below 200 Hz; write for example
// Below, drives would notice too late that nobody commands them; above, no bus carries the frames.
#include "arm_on_drives.hpp"

struct arm : described_arm {
#if CCA_REJECT
  using rate = cca::rate<100>;
#else
  using rate = cca::rate<1000>;
#endif
};

struct robot : cca::hardware::robot<arm, bus, upper, lower> {};
