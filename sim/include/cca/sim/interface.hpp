#pragma once
// What goes into the simulated robot in a beat and what comes out: commands to the motors, readings of the
// sensors.
#include <array>

#include <cca/sim/attitude.hpp>
#include <cca/sim/oncilla_model.hpp>

namespace cca::sim {

// Position targets of one leg's motors, rad. The knee's is the flexion that the cable is wound to. A target
// that isn't finite is not taken: the motor keeps the last finite one (before any, the angle that the robot
// was put down with). Finite targets are cut to the joint's range.
struct leg_command {
  double hip = 0;
  double knee = 0;
  double abduction = 0;
  double hip_stiffness =
      oncilla_defaults.hip_stiffness;  // N m/rad, damping goes with it; negative or not finite: kept
};

using robot_command = std::array<leg_command, leg_count>;

// What a drive with a loop of its own makes of a joint: torque = stiffness (position - q) + damping (velocity
// - v) + torque, for the whole beat. Of the knee only what flexes it gets through the cable. Neither is cut
// to the joint's range: that is the business of whoever commands such a drive. Laws that aren't finite are
// not taken: the drive keeps the last one.
struct joint_law {
  double position = 0;   // rad
  double velocity = 0;   // rad/s
  double torque = 0;     // N m
  double stiffness = 0;  // N m/rad
  double damping = 0;    // N m s/rad

  double operator()(double angle, double speed) const {
    return stiffness * (position - angle) + damping * (velocity - speed) + torque;
  }
};
struct leg_laws {
  joint_law hip, knee;
  double abduction = 0;  // target, rad
};
using robot_laws = std::array<leg_laws, leg_count>;

struct joint_reading {
  double angle = 0;     // rad
  double velocity = 0;  // rad/s
  double torque = 0;    // N m of the motor, positive towards larger angles
};

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
  vector3 specific_force{};  // m/s^2, what an accelerometer shows: acceleration minus gravity, mean over the
                             // beat; (0, 0, +9.81) at rest on level ground
};

struct robot_reading {
  std::array<leg_reading, leg_count> legs{};
  trunk_reading trunk{};
};

// How a robot is put down. The trunk is level, its height such that the lowest foot is just above the ground.
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
