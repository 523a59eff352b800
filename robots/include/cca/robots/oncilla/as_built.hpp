// The Oncilla as it was built, with the ports by which its controllers know it: hips and knees have drives,
// the abductions are servos, and a board on the trunk senses.
//
//   in   "command"       leg_angles: hips and knees, rad
//        "abduction"     abduction_angles, rad; before the first one the servos hold the legs where they are
//        "stiffness"     hip_stiffnesses, N m/rad; before the first one the servos' own
//   out  "angles"        leg_angles            "velocities"        leg_velocities
//        "torques"       leg_torques           "orientation"       trunk_orientation
//        "acceleration"  trunk_acceleration    "angular_velocity"  trunk_angular_velocity
//        "contacts"      foot_contacts         "foot_loads"        foot_loads
//        "abducted"      abduction_angles
//
// All else is that of description.hpp: the same body, drives and springs.
#pragma once

#include <array>
#include <cstddef>

#include <cca/robots/groups.hpp>
#include <cca/robots/oncilla/description.hpp>

namespace cca::robots::oncilla {

struct as_built : description {
  // [groups]
  using commands = robots::commands<of_joints<"command", position_command, leg_angles>,
                                    of_joints<"abduction", position_command, abduction_angles>,
                                    hint<of_joints<"stiffness", stiffness_command, hip_stiffnesses>>>;
  using readings = robots::readings<angles_of<"angles", leg_angles>,
                                    velocities_of<"velocities", leg_velocities>,
                                    torques_of<"torques", leg_torques>,
                                    angles_of<"abducted", abduction_angles>>;
  // [groups end]
  using sensors = robots::sensors<orientation_sensor<"orientation", world_frame>,
                                  accelerometer<"acceleration">,
                                  gyroscope<"angular_velocity">,
                                  robots::foot_contacts<"contacts",
                                                        foot_axes,
                                                        "left_front_leg",
                                                        "right_front_leg",
                                                        "left_hind_leg",
                                                        "right_hind_leg">,
                                  robots::foot_loads<"foot_loads",
                                                     foot_axes,
                                                     "left_front_leg",
                                                     "right_front_leg",
                                                     "left_hind_leg",
                                                     "right_hind_leg">>;

  static constexpr auto drives = [] {
    auto all = description::drives;
    for (joint_drive& d : all) d.holds = d.motor.torque > 0;
    return all;
  }();
};

}  // namespace cca::robots::oncilla
