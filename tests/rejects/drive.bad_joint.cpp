// EXPECT: drive\.bad_joint: the mounting of the joint `knee` is impossible: its `gear` is -2, and it is above 0; a drive that turns the other way round has `sign` -1
// A drive that turns the other way round has a sign, not a negative gear: the gear also scales the limits.
#include <cca/hardware/joint.hpp>
#include <cca/hardware/mit.hpp>

struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 2}, cca::velocity{-9, 9}, cca::torque{-8, 8}};
};
using motor = cca::hardware::mit_drive<cca::hardware::ak80_9, 1>;

#if CCA_REJECT
struct left_knee : cca::hardware::joint<knee,
                                        motor,
                                        cca::hardware::mounting{.gear = -2},
                                        cca::hardware::joint_servo{.stiffness = 30}> {};
#else
struct left_knee : cca::hardware::joint<knee,
                                        motor,
                                        cca::hardware::mounting{.gear = 2, .sign = -1},
                                        cca::hardware::joint_servo{.stiffness = 30}> {};
#endif

double middle = left_knee::angle_of(0);
