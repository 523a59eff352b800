// EXPECT: robot\.drives: a servo of the board of arm moves `left_front_abduction`, an axis that its body does not measure; use a board
// LINES: 15
// The board of an Oncilla has servos for its abductions, which an arm has not.
#include <cca/hardware/oncilla/sensor_board.hpp>

#include "arm_on_drives.hpp"

struct arm : described_arm {};

#if CCA_REJECT
struct board : cca::hardware::sensor_board<0x40, 1> {};
struct robot : cca::hardware::robot<arm, bus, upper, lower, board> {};
#else
struct robot : cca::hardware::robot<arm, bus, upper, lower> {};
#endif
