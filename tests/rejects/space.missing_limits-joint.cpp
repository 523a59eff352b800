// EXPECT: space\.missing_limits: the axis `knee` of a joint states no limits of velocity and torque; a drive is commanded only within limits: add `cca::velocity{lower, upper}`, `cca::torque{lower, upper}` to the `limits` of its dimension
// A limiter needs only the limits of what it limits; a drive stops on all three.
#include <cca/hardware/joint.hpp>
#include <cca/hardware/mit.hpp>

// Refused by a static_assert of the joint, without a graph.

struct knee : cca::dimension<"knee"> {
#if CCA_REJECT
  static constexpr auto limits = cca::limits{cca::angle{-1, 2}};
#else
  static constexpr auto limits = cca::limits{cca::angle{-1, 2}, cca::velocity{-9, 9}, cca::torque{-8, 8}};
#endif
};
struct left_knee : cca::hardware::joint<knee,
                                        cca::hardware::mit_drive<cca::hardware::ak80_9, 1>,
                                        cca::hardware::mounting{},
                                        cca::hardware::joint_servo{.stiffness = 30}> {};

double middle = left_knee::angle_of(0);
