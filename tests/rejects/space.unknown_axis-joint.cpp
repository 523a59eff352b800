// EXPECT: space\.unknown_axis: no joint of this robot has the axis ankle: its joints have shoulder, elbow; name one of these
// LINES: 18
// The motor and the virtual drive of a joint are found by its axis. This file stands alone since the message
// is about a robot's joints; others of the rule are about a space.
#include <cca/hardware/virtual_hardware.hpp>

#include "arm_on_drives.hpp"

struct ankle : cca::dimension<"ankle"> {};
struct robot : cca::hardware::robot<described_arm, bus, upper, lower> {};

void put(cca::hardware::virtual_motors<robot::joints>& motors) {
#if CCA_REJECT
  motors.put_at<ankle>(0.3);
#else
  motors.put_at<elbow>(0.3);
#endif
}
