// EXPECT: drive\.bad_number: the node of EPOS4 is 0, and a node of CANopen is 1 to 127
// Node 0 of CANopen means all nodes.
#include <cca/hardware/cia402.hpp>

struct epos {
  static constexpr std::string_view name = "EPOS4";
  static constexpr double counts = 65536, torque = 2;
};
#if CCA_REJECT
using hip = cca::hardware::cia402<epos, 0, cca::hardware::cia402_mode::torque>;
#else
using hip = cca::hardware::cia402<epos, 127, cca::hardware::cia402_mode::torque>;
#endif

auto off = hip::disable();
