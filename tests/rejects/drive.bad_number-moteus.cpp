// EXPECT: drive\.bad_number: the number of n1 is 5, and we send from 5: a moteus has a number from 1 to 127, and not the one that we send from
// Number 0 is ours, unless the source states another one.
#include <cca/hardware/moteus.hpp>

struct n1 {
  static constexpr std::string_view name = "n1";
  static constexpr double stiffness = 80, damping = 2, torque = 12, timeout = 0.02;
};
#if CCA_REJECT
using hip = cca::hardware::moteus<n1, 5, 5>;
#else
using hip = cca::hardware::moteus<n1, 127, 5>;
#endif

auto off = hip::disable();
