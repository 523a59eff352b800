// EXPECT: robot\.drives: the joint `wrist`, which is number 3 after the bus of arm, is one too many: its body does not measure this axis
// LINES: 15
// The body has no wrist.
#include "arm_on_drives.hpp"

struct arm : described_arm {};

#if CCA_REJECT
struct wrist : cca::dimension<"wrist"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}, cca::velocity{-5, 5}, cca::torque{-10, 10}};
};
struct third : driven<wrist, 3> {};
struct robot : cca::hardware::robot<arm, bus, upper, lower, third> {};
#else
struct robot : cca::hardware::robot<arm, bus, upper, lower> {};
#endif
