// EXPECT: drive\.bad_joint: the axis `wheel` of this joint is continuous, but the position of its drive, AK80-9, ends after 3\.979 turns of the joint
// A drive that stays at the end of its range would no longer measure where a wheel is.
#include <cca/hardware/joint.hpp>
#include <cca/hardware/mit.hpp>

struct wheel : cca::dimension<"wheel"> {
  static constexpr bool continuous = true;
  static constexpr auto limits = cca::limits{cca::velocity{-9, 9}, cca::torque{-8, 8}};
};
using motor = cca::hardware::mit_drive<cca::hardware::ak80_9, 1>;

#if CCA_REJECT
constexpr cca::hardware::mounting mounted{};
#else
constexpr cca::hardware::mounting mounted{.wraps = 25};
#endif
struct left_wheel : cca::hardware::joint<wheel, motor, mounted, cca::hardware::joint_servo{.stiffness = 30}> {
};

double middle = left_wheel::angle_of(0);
