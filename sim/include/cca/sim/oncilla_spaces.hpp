#pragma once
// The spaces of the simulated Oncilla: its joints as axes, with limits from the model, and what is measured
// along them.
//
// Axes of eight run hips first, then knees, each left front, right front, left hind, right hind. Hip: 0
// straight down, positive forward; knee: flexion; abduction: positive outward. Units: rad, rad/s, N m, N,
// m/s^2.
#include <string_view>

#include <cca/space/domain.hpp>
#include <cca/space/record.hpp>

#include <cca/sim/oncilla_model.hpp>

namespace cca::sim {

inline constexpr auto hip_limits = [] {
  constexpr const oncilla_model& m = oncilla_defaults;
  return cca::limits{cca::angle{m.hip_range.low, m.hip_range.high},
                     cca::velocity{-m.hip_motor.no_load_speed, m.hip_motor.no_load_speed},
                     cca::torque{-m.hip_motor.torque, m.hip_motor.torque},
                     cca::stiffness{0.0, m.stiffest_hip}};
}();

// The cable only flexes the knee: torques are positive.
inline constexpr auto knee_limits = [] {
  constexpr const oncilla_model& m = oncilla_defaults;
  return cca::limits{cca::angle{m.knee_range.low, m.knee_range.high},
                     cca::velocity{-m.knee_motor.no_load_speed, m.knee_motor.no_load_speed},
                     cca::torque{0.0, m.knee_motor.torque}};
}();

inline constexpr auto abduction_limits = [] {
  constexpr const oncilla_model& m = oncilla_defaults;
  return cca::limits{cca::angle{m.abduction_range.low, m.abduction_range.high},
                     cca::velocity{-m.abduction_motor.no_load_speed, m.abduction_motor.no_load_speed},
                     cca::torque{-m.abduction_motor.torque, m.abduction_motor.torque}};
}();

struct left_front_hip : cca::dimension<"left_front_hip"> {
  static constexpr auto limits = hip_limits;
};
struct right_front_hip : cca::dimension<"right_front_hip"> {
  static constexpr auto limits = hip_limits;
};
struct left_hind_hip : cca::dimension<"left_hind_hip"> {
  static constexpr auto limits = hip_limits;
};
struct right_hind_hip : cca::dimension<"right_hind_hip"> {
  static constexpr auto limits = hip_limits;
};
struct left_front_knee : cca::dimension<"left_front_knee"> {
  static constexpr auto limits = knee_limits;
};
struct right_front_knee : cca::dimension<"right_front_knee"> {
  static constexpr auto limits = knee_limits;
};
struct left_hind_knee : cca::dimension<"left_hind_knee"> {
  static constexpr auto limits = knee_limits;
};
struct right_hind_knee : cca::dimension<"right_hind_knee"> {
  static constexpr auto limits = knee_limits;
};
struct left_front_abduction : cca::dimension<"left_front_abduction"> {
  static constexpr auto limits = abduction_limits;
};
struct right_front_abduction : cca::dimension<"right_front_abduction"> {
  static constexpr auto limits = abduction_limits;
};
struct left_hind_abduction : cca::dimension<"left_hind_abduction"> {
  static constexpr auto limits = abduction_limits;
};
struct right_hind_abduction : cca::dimension<"right_hind_abduction"> {
  static constexpr auto limits = abduction_limits;
};

struct left_front_foot : cca::dimension<"left_front_foot"> {};
struct right_front_foot : cca::dimension<"right_front_foot"> {};
struct left_hind_foot : cca::dimension<"left_hind_foot"> {};
struct right_hind_foot : cca::dimension<"right_hind_foot"> {};

using hip_axes = cca::axes<left_front_hip, right_front_hip, left_hind_hip, right_hind_hip>;
using leg_axes = cca::axes<left_front_hip,
                           right_front_hip,
                           left_hind_hip,
                           right_hind_hip,  //
                           left_front_knee,
                           right_front_knee,
                           left_hind_knee,
                           right_hind_knee>;
using abduction_axes =
    cca::axes<left_front_abduction, right_front_abduction, left_hind_abduction, right_hind_abduction>;
using foot_axes = cca::axes<left_front_foot, right_front_foot, left_hind_foot, right_hind_foot>;
using robot_rate = cca::rate<1000>;

struct world_frame {};  // x forward at the start, z up
struct trunk_frame {};  // x forward, y left, z up, in the trunk's centre

// What an inertial unit measures besides its orientation, along the axes of a frame.
template <class Frame>
struct angular_velocity {
  using quantity = cca::velocity;  // rad/s
  static constexpr bool actuated = false;
  static constexpr int width(int axes) { return axes; }
  static constexpr double zero(int, int) { return 0; }
  template <class Self>
  struct methods {};
};

struct linear_acceleration {
  double lower, upper;
  static constexpr std::string_view unit = "m/s^2";
  static constexpr auto on_nan = nan_policy::zero;
};

// Acceleration minus gravity: what an accelerometer shows; upwards, 9.81 m/s^2 at rest.
template <class Frame>
struct specific_force {
  using quantity = linear_acceleration;
  static constexpr bool actuated = false;
  static constexpr int width(int axes) { return axes; }
  static constexpr double zero(int, int) { return 0; }
  template <class Self>
  struct methods {};
};

// The vertical part of what the ground does to a foot; 0: no contact.
struct foot_load {
  using quantity = cca::force;
  static constexpr bool actuated = false;
  static constexpr int width(int axes) { return axes; }
  static constexpr double zero(int, int) { return 0; }
  template <class Self>
  struct methods {};
};

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

// What the synchronizer reads for a node, in the simulator's own form.
template <int Numbers>
struct simulator_record : record<Numbers> {};

template <class Axis>
struct measured_joint : cca::space<simulator_record<3>, cca::axes<Axis>, robot_rate> {
};  // angle, velocity, torque
struct trunk_part : cca::dimension<"trunk"> {};
struct measured_trunk : cca::space<simulator_record<22>, cca::axes<trunk_part>, robot_rate> {
};  // see simulator.hpp

}  // namespace cca::sim
