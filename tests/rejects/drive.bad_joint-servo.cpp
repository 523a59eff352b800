// EXPECT: drive\.bad_joint: `safe_damping` of the servo of the joint `knee`, with which it stops, is 2, above its `most_damping`, 1; raise
// `most_damping` is the most that anybody can ask the drive for, so a stop can't have more.
#include <cca/hardware/joint.hpp>
#include <cca/hardware/mit.hpp>

struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 2}, cca::velocity{-9, 9}, cca::torque{-8, 8}};
};
using motor = cca::hardware::mit_drive<cca::hardware::ak80_9, 1>;

#if CCA_REJECT
constexpr cca::hardware::joint_servo servo{.stiffness = 30, .safe_damping = 2, .most_damping = 1};
#else
constexpr cca::hardware::joint_servo servo{.stiffness = 30, .safe_damping = 2, .most_damping = 3};
#endif
struct left_knee : cca::hardware::joint<knee, motor, cca::hardware::mounting{}, servo> {};

double middle = left_knee::angle_of(0);
