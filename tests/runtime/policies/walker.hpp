// The robot of walk/: in its order of joints, and with a left knee that counts the other way round.
#pragma once

#include "robot.hpp"

namespace policies::walker {

struct world : cca::frame<"world"> {};
struct left_knee_bend : cca::dimension<"left_knee_bend"> {
  static constexpr auto limits = cca::limits{cca::angle{0, 2.5}, cca::torque{-30, 30}};
};
using joints = cca::axes<right_knee, left_knee_bend, left_hip, right_hip>;

struct attitude : cca::space<cca::orientation<world>, xyz> {};
struct angles : cca::space<cca::joint_angles, joints> {};
struct velocities : cca::space<cca::joint_velocities, joints> {};
struct torques : cca::space<cca::joint_torques, joints> {};
struct targets : cca::space<cca::joint_angles, joints, cca::rate<50>> {};

// [walker]
using observations = cca::policy_inputs<cca::in<"joint_vel_rel", velocities>,
                                        cca::in<"base_ang_vel", gyro>,
                                        cca::in<"attitude", attitude>,
                                        cca::in<"joint_pos_rel", angles>,
                                        cca::in<"velocity_commands", command>>;

template <class Contract>
struct walking : cca::imported_policy<Contract, observations, targets> {};
// [walker end]

}  // namespace policies::walker
