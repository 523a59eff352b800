// The robot of the tests of imported policies: other orders of joints than the policies.
#pragma once

#include <cca/cca.hpp>
#include <cca/mapping/imported/imported_policy.hpp>
#include <cca/robots/inertial.hpp>

namespace policies {

struct trunk : cca::frame<"trunk"> {};
struct left_hip : cca::dimension<"left_hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}, cca::torque{-30, 30}};
};
struct left_knee : cca::dimension<"left_knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-2.5, 0}, cca::torque{-30, 30}};
};
struct right_hip : cca::dimension<"right_hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-1, 1}, cca::torque{-30, 30}};
};
struct right_knee : cca::dimension<"right_knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-2.5, 0}, cca::torque{-30, 30}};
};
struct forward : cca::dimension<"forward"> {};
struct turning : cca::dimension<"turning"> {};

using joints = cca::axes<right_knee, left_hip, right_hip, left_knee>;
using xyz = cca::axes<cca::x, cca::y, cca::z>;

struct gyro : cca::space<cca::robots::angular_velocity<trunk>, xyz> {};
struct gravity : cca::space<cca::cartesian_position<trunk>, xyz> {};
struct command : cca::space<cca::number, cca::axes<turning, forward>> {};
struct angles : cca::space<cca::joint_angles, joints> {};
struct velocities : cca::space<cca::joint_velocities, joints> {};
struct torques : cca::space<cca::joint_torques, joints> {};
struct targets : cca::space<cca::joint_angles, joints, cca::rate<50>> {};

using observations = cca::policy_inputs<cca::in<"base_ang_vel", gyro>,
                                        cca::in<"projected_gravity", gravity>,
                                        cca::in<"velocity_commands", command>,
                                        cca::in<"joint_pos", angles>,
                                        cca::in<"joint_vel", velocities>>;

template <class Contract>
struct walking : cca::imported_policy<Contract, observations, targets> {};

}  // namespace policies
