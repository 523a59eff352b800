// EXPECT: robot\.drives: arm has force sensors: 1, inertial ones: 0, feet: 0, but no board; after the joints add a cca::hardware::robot_board
// In the simulator a force sensor needs nothing else; a real one is on a bus.
#include "arm_on_drives.hpp"

struct arm : described_arm {
  using sensors = cca::robots::sensors<cca::robots::force_sensor<"load", "arm">>;
};

#if CCA_REJECT
struct robot : cca::hardware::robot<arm, bus, upper, lower> {};
#else
struct robot : cca::hardware::robot<arm, bus, upper, lower, cca::hardware::load_board<0x100, 1, 1>> {};
#endif
