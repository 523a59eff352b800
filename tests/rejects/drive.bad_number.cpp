// EXPECT: drive\.bad_number: node 63 \(0x3F\) of an ODrive with firmware 0\.6 means `not addressed`: it would hear nothing; use another
// Each family says which numbers a drive can have on its bus; with another one nobody would answer.
#include <cca/hardware/odrive.hpp>

#if CCA_REJECT
using hip = cca::hardware::odrive<63, cca::hardware::odrive_mode::position>;
#else
using hip = cca::hardware::odrive<62, cca::hardware::odrive_mode::position>;
#endif
using old =
    cca::hardware::odrive<63, cca::hardware::odrive_mode::position, cca::hardware::odrive_firmware::v0_5>;

auto off = hip::disable();
auto off_too = old::disable();
