// The spaces of an Oncilla's ports: those of the whole robot, those of one joint, and the raw readings that
// its synchronizer hands to the resource nodes.
//
// Units: rad, rad/s, N m, N, m/s^2. Rate: 1 kHz.
#pragma once

#include <cca/robots/inertial.hpp>
#include <cca/robots/oncilla/axes.hpp>
#include <cca/robots/record.hpp>
#include <cca/space/domain.hpp>
#include <cca/space/record.hpp>

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

// Raw readings, from the synchronizer to the resource nodes.
template <int Numbers>
struct raw_record : cca::record<Numbers> {};

template <class Axis>
struct joint_record : record_of<field<"angle", joint_angle<Axis>>,
                                field<"velocity", joint_velocity<Axis>>,
                                field<"torque", joint_torque<Axis>>> {};
template <class Axis>
struct measured_joint : cca::space<raw_record<joint_record<Axis>::size>, cca::axes<Axis>, robot_rate> {};

// The trunk's sensors: the inertial unit, the feet, and the abduction servos.
struct trunk_record : record_of<field<"orientation", trunk_orientation>,  // x y z w
                                field<"angular_velocity", trunk_angular_velocity>,
                                field<"acceleration", trunk_acceleration>,
                                field<"foot_loads", foot_loads>,
                                field<"contacts", foot_contacts>,  // 1: the foot touches
                                field<"abducted", abduction_angles>> {};
struct trunk_part : cca::dimension<"trunk"> {};
struct measured_trunk : cca::space<raw_record<trunk_record::size>, cca::axes<trunk_part>, robot_rate> {};

}  // namespace cca::robots::oncilla
