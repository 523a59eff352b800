// EXPECT: drive\.duplicate_id: on the bus `left` the drives 1 \(EPOS4\) and 2 \(AK80-9\) both use the id 0x605
// A CANopen node uses more ids than those of its process data: a frame with the id 0x605 would write the
// objects of node 5.
#include <cca/hardware/bus_plan.hpp>
#include <cca/hardware/cia402.hpp>
#include <cca/hardware/mit.hpp>

struct hip_motor {
  static constexpr std::string_view name = "EPOS4";
  static constexpr double counts = 4096, torque = 0.8;
};
using hip = cca::hardware::cia402<hip_motor, 5, cca::hardware::cia402_mode::torque>;
#if CCA_REJECT
using knee = cca::hardware::mit_drive<cca::hardware::ak80_9, 1, 0x605>;
#else
using knee = cca::hardware::mit_drive<cca::hardware::ak80_9, 1, 0x606>;
#endif

struct left
    : cca::hardware::can_bus_plan<"left", cca::hardware::bit_rates{1'000'000}, cca::rate<400>, hip, knee> {};

double used = left::load;
