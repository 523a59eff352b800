// EXPECT: drive\.bad_number: the ODrive of node 3 has firmware 0\.5, which sends no torques: leave out their period
// A start would wait for them in vain.
#include <cca/hardware/odrive.hpp>

namespace hw = cca::hardware;
#if CCA_REJECT
using hip = hw::odrive<3, hw::odrive_mode::torque, hw::odrive_firmware::v0_5, 10'000'000, 10'000'000>;
#else
using hip = hw::odrive<3, hw::odrive_mode::torque, hw::odrive_firmware::v0_6, 10'000'000, 10'000'000>;
#endif

auto off = hip::disable();
