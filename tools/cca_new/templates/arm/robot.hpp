// The robot: an arm of seven joints that takes torques. Its axes, masses and motors are those of the
// library's arm; for your own, write a description like <cca/robots/arm/description.hpp>, or make this
// project again from its URDF file: `cca-new NAME --from my_arm.urdf`.
#pragma once

#include <cca/cca.hpp>
#include <cca/robot/compliance/compliance_spaces.hpp>
#include <cca/robots/arm/description.hpp>

namespace my_robot {

using cca::robots::arm::angles;
using cca::robots::arm::body;
using cca::robots::arm::description;
using cca::robots::arm::torques;
using cca::robots::arm::velocities;

using base = cca::robots::arm::base_frame;      // x forward, z up
using flange = cca::robots::arm::flange_frame;  // in which the hand is

using hand = cca::pose_in<base>;                   // m, and how it is turned
using hand_motion = cca::motion_of<flange, base>;  // rad/s, m/s

}  // namespace my_robot
