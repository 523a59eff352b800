// The spaces of an Oncilla's ports: those of the whole robot, and those of one joint.
//
// Units: rad, rad/s, N m, N, m/s^2. Rate: 1 kHz.
#pragma once

#include <cca/robots/inertial.hpp>
#include <cca/robots/oncilla/axes.hpp>
#include <cca/space/domain.hpp>

namespace cca::robots::oncilla {

using robot_rate = cca::rate<1000>;

struct world_frame {};  // x forward at the start, z up
struct trunk_frame {};  // x forward, y left, z up, in the trunk's centre

using robots::angular_velocity;
using robots::foot_load;
using robots::linear_acceleration;
using robots::specific_force;

// The whole robot.
struct leg_angles : cca::space<cca::joint_angles, leg_axes, robot_rate> {};
struct leg_velocities : cca::space<cca::joint_velocities, leg_axes, robot_rate> {};
struct leg_torques : cca::space<cca::joint_torques, leg_axes, robot_rate> {};
struct hip_stiffnesses : cca::space<cca::joint_stiffness, hip_axes, robot_rate> {};
struct abduction_angles : cca::space<cca::joint_angles, abduction_axes, robot_rate> {};
struct foot_contacts : cca::space<cca::status, foot_axes, robot_rate> {};
struct foot_loads : cca::space<foot_load, foot_axes, robot_rate> {};
struct trunk_orientation
    : cca::space<cca::orientation<world_frame>, cca::axes<cca::x, cca::y, cca::z>, robot_rate> {};
struct trunk_angular_velocity
    : cca::space<angular_velocity<trunk_frame>, cca::axes<cca::x, cca::y, cca::z>, robot_rate> {};
struct trunk_acceleration
    : cca::space<specific_force<trunk_frame>, cca::axes<cca::x, cca::y, cca::z>, robot_rate> {};

// One joint.
template <class Axis>
struct joint_angle : cca::space<cca::joint_angles, cca::axes<Axis>, robot_rate> {};
template <class Axis>
struct joint_velocity : cca::space<cca::joint_velocities, cca::axes<Axis>, robot_rate> {};
template <class Axis>
struct joint_torque : cca::space<cca::joint_torques, cca::axes<Axis>, robot_rate> {};

}  // namespace cca::robots::oncilla
