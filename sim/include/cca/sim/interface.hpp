// Input and output of the simulated robot in a beat: commands to the motors, readings of the sensors.
#pragma once

#include <array>

#include <cca/sim/attitude.hpp>
#include <cca/sim/oncilla_model.hpp>
#include <cca/sim/robot/joint_law.hpp>

namespace cca::sim {

// Position targets of one leg's motors, rad. The knee's target is the flexion that the cable is wound to. A
// target that isn't finite is ignored: the motor keeps the last finite one, at first the angle that the robot
// was put down with. Finite targets are clamped to the joint's range.
struct leg_command {
  double hip = 0;
  double knee = 0;
  double abduction = 0;
  double hip_stiffness =
      oncilla_defaults.hip_stiffness;  // N m/rad, scales the damping; negative or not finite: keep the last
};

using robot_command = std::array<leg_command, leg_count>;

// The control laws of a leg's drives for the whole beat. The cable passes on only torques that flex the knee.
struct leg_laws {
  joint_law hip, knee;
  double abduction = 0;  // target, rad
};
using robot_laws = std::array<leg_laws, leg_count>;

struct leg_reading {
  joint_reading hip, knee, abduction;  // the knee's torque is the cable's
  joint_reading toe;                   // passive: its torque is the spring's
  vector3 foot_force{};                // N on the foot, in the world's axes, mean over the beat

  bool contact() const { return foot_force != vector3{}; }
};

// An inertial unit in the trunk's centre, axes of the trunk.
struct trunk_reading {
  quaternion orientation;      // turns the trunk's axes into the world's
  vector3 angular_velocity{};  // rad/s
  vector3 specific_force{};    // m/s^2, the reading of an accelerometer: acceleration minus gravity, mean
                               // over the beat; (0, 0, +9.81) at rest on level ground
};

struct robot_reading {
  std::array<leg_reading, leg_count> legs{};
  trunk_reading trunk{};
};

// The posture in which a robot is put down. The trunk is level; its height puts the lowest foot just above
// the ground.
struct leg_posture {
  double hip = 0;
  double knee = 1.4;
  double abduction = 0;
};

struct initial_posture {
  std::array<leg_posture, leg_count> legs{};
  vector3 trunk_velocity{};
};

}  // namespace cca::sim
