// EXPECT: drive\.duplicate_id: on the bus `left` the drives 1 \(ODrive 0\.6\) and 2 \(AK80-9\) both use the id 0x036
// An ODrive owns all 32 ids of its node, even those that no set-point uses: 0x36 would reboot node 1.
#include <cca/hardware/bus_plan.hpp>
#include <cca/hardware/mit.hpp>
#include <cca/hardware/odrive.hpp>

using hip = cca::hardware::odrive<1, cca::hardware::odrive_mode::torque>;
#if CCA_REJECT
using knee = cca::hardware::mit_drive<cca::hardware::ak80_9, 0x36>;
#else
using knee = cca::hardware::mit_drive<cca::hardware::ak80_9, 0x46>;
#endif

struct left
    : cca::hardware::can_bus_plan<"left", cca::hardware::bit_rates{1'000'000}, cca::rate<400>, hip, knee> {};

double used = left::load;
