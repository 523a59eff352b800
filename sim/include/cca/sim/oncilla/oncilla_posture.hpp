// What an Oncilla's legs are told and read in a simulated world, by leg instead of by joint, and the posture
// in which it is put down.
#pragma once

#include <array>

#include <cca/sim/oncilla/attitude.hpp>
#include <cca/sim/oncilla/kinematics.hpp>
#include <cca/sim/oncilla/oncilla_model.hpp>
#include <cca/sim/robot/model/joint_law.hpp>

namespace cca::sim {

// Targets of the motors, rad; the stiffness of the hip's servo, N m/rad.
struct leg_command {
  double hip = 0, knee = 0, abduction = 0, hip_stiffness = 0;
};
using robot_command = std::array<leg_command, leg_count>;

struct leg_reading {
  joint_reading hip, knee, abduction;  // the knee's torque is the cable's
  joint_reading toe;                   // passive: no torque of a motor
  vector3 foot_force{};                // N on the foot, in the world's axes, mean over the beat

  bool contact() const { return foot_force != vector3{}; }
};

// An inertial unit in the trunk's centre, axes of the trunk.
struct trunk_reading {
  quaternion orientation;      // turns the trunk's axes into the world's
  vector3 angular_velocity{};  // rad/s
  vector3 specific_force{};    // m/s^2, acceleration minus gravity, mean over the beat
};

struct robot_reading {
  std::array<leg_reading, leg_count> legs{};
  trunk_reading trunk{};
};

// The trunk is level; its height puts the lowest foot just above the ground.
struct leg_posture {
  double hip = 0, knee = 1.4, abduction = 0;
};
struct initial_posture {
  std::array<leg_posture, leg_count> legs{};
  vector3 trunk_velocity{};
};

// Feet a little ahead of the hips, where the springs carry the robot.
inline initial_posture standing_posture() {
  const leg_angles_in_plane q = leg_angles_for(oncilla_defaults, {0.04, -0.165});
  initial_posture posture;
  for (leg_posture& leg : posture.legs) leg = {q.hip, q.knee, 0};
  return posture;
}

}  // namespace cca::sim
