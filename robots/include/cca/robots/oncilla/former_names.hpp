// The names of the Oncilla's axes and spaces in cca::sim, where version 0.1.0 had them. Programs for the
// simulated and for the real robot use them; new code can use cca::robots::oncilla.
#pragma once

#include <cca/robots/oncilla/spaces.hpp>

namespace cca::sim {

using robots::oncilla::degrees;
using robots::oncilla::interval;
using robots::oncilla::is_front;
using robots::oncilla::leg_count;
using robots::oncilla::leg_id;
using robots::oncilla::motor_line;
using robots::oncilla::side_of;

using robots::oncilla::abduction_limits;
using robots::oncilla::hip_limits;
using robots::oncilla::knee_limits;

using robots::oncilla::left_front_hip;
using robots::oncilla::left_hind_hip;
using robots::oncilla::right_front_hip;
using robots::oncilla::right_hind_hip;

using robots::oncilla::left_front_knee;
using robots::oncilla::left_hind_knee;
using robots::oncilla::right_front_knee;
using robots::oncilla::right_hind_knee;

using robots::oncilla::left_front_abduction;
using robots::oncilla::left_hind_abduction;
using robots::oncilla::right_front_abduction;
using robots::oncilla::right_hind_abduction;

using robots::oncilla::left_front_foot;
using robots::oncilla::left_hind_foot;
using robots::oncilla::right_front_foot;
using robots::oncilla::right_hind_foot;

using robots::oncilla::abduction_axes;
using robots::oncilla::foot_axes;
using robots::oncilla::hip_axes;
using robots::oncilla::leg_axes;
using robots::oncilla::robot_rate;

using robots::oncilla::trunk_frame;
using robots::oncilla::world_frame;

using robots::oncilla::angular_velocity;
using robots::oncilla::foot_load;
using robots::oncilla::linear_acceleration;
using robots::oncilla::specific_force;

using robots::oncilla::abduction_angles;
using robots::oncilla::foot_contacts;
using robots::oncilla::foot_loads;
using robots::oncilla::hip_stiffnesses;
using robots::oncilla::leg_angles;
using robots::oncilla::leg_torques;
using robots::oncilla::leg_velocities;
using robots::oncilla::trunk_acceleration;
using robots::oncilla::trunk_angular_velocity;
using robots::oncilla::trunk_orientation;

using robots::oncilla::joint_angle;
using robots::oncilla::joint_torque;
using robots::oncilla::joint_velocity;

}  // namespace cca::sim
