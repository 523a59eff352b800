// The body of an Oncilla in one table: lengths, masses, joint ranges, springs and motors. SI units, radians.
//
// Published for the real robot are the total mass of 5.1 kg, a hip height of about 0.16 to 0.18 m, the kind
// of leg (three segments, pantograph, diagonal spring, knee cable, passive toe, abduction servo) and that a
// trot reaches 0.63 m/s (Sproewitz et al., Frontiers in Robotics and AI 5:67, 2018). No other number is
// published in a form that could be used. All others, the limits of the joints among them, are CHOSEN, so
// that a leg made of them stands and trots like the real one. Measure your robot before you let this table
// limit it.
//
// The limits of the axes (axes.hpp), the simulator's model and the kinematics are all computed from
// `oncilla::body`. Ranges and motors bound commands to simulated and real joints alike.
#pragma once

#include <cca/robots/motor_line.hpp>
#include <cca/robots/oncilla/legs.hpp>

namespace cca::robots::oncilla {

struct interval {
  double low, high;
  constexpr double clamp(double x) const { return x < low ? low : (x > high ? high : x); }
  constexpr bool holds(double x) const { return low <= x && x <= high; }
};

using robots::motor_line;

struct body_numbers {
  // Trunk: a box whose centre of mass lies above the middle of the four hips. It carries the abduction
  // servos. All chosen.
  double trunk_length = 0.280;
  double trunk_width = 0.110;
  double trunk_height = 0.080;
  double trunk_above_hips = 0.020;
  double trunk_forward_of_hips = 0.0;
  double trunk_mass = 3.66;  // so that the total mass is the published one
  double hip_x = 0.1175;     // half the distance of front and hind hips
  double hip_y = 0.075;      // half the distance of left and right hips

  // Leg: upper, middle and lower segment and a toe; upper and lower stay parallel (pantograph). All chosen.
  double upper_length = 0.078;
  double middle_length = 0.095;
  double lower_length = 0.035;  // from the ankle to the toe joint
  double toe_length = 0.025;    // from the toe joint to the centre of the foot's sphere
  double foot_radius = 0.012;
  double upper_mass = 0.18;
  double middle_mass = 0.10;
  double lower_mass = 0.06;
  double toe_mass = 0.02;
  double segment_radius = 0.014;  // of the cylinders that give the segments their inertia
  double knee_radius = 0.012;     // spheres that touch the ground when a leg kneels
  double ankle_radius = 0.010;

  // Joint ranges, all chosen. Hip: 0 is straight down, positive swings the foot forward. Knee: flexion, 0
  // would be the straight leg. Abduction: positive moves the foot outward. Toe: 0 continues the lower
  // segment.
  interval hip_range{-1.2, 1.9};  // forward beyond the horizontal, to reach
  interval knee_range{degrees(35), degrees(150)};
  interval abduction_range{degrees(-20), degrees(20)};
  interval toe_range{-0.8, 0.8};
  double joint_friction = 0.02;  // of the knee, N m s/rad

  // Diagonal spring from the knee to a point of the lower segment, `spring_arm` beyond the ankle. Chosen.
  double spring_rate = 6254.0;  // N/m
  double spring_arm = 0.035;
  double spring_reference = degrees(60);  // flexion at which the spring's stretch is `spring_preload`
  double spring_preload = -0.0143;        // negative: slack below 83 degrees of flexion

  // Toe spring: a torsion spring with friction in the passive joint. Chosen.
  double toe_stiffness = 2.0;  // N m/rad
  double toe_damping = 0.003;  // N m s/rad

  // Motors, chosen. The knee's motor winds a cable, so it can only flex the knee.
  motor_line hip_motor{6.0, 14.0};
  motor_line knee_motor{6.0, 16.0};
  motor_line abduction_motor{3.0, 6.0};
  double stiffest_hip = 200.0;  // N m/rad; a stiffer servo chatters at 1 kHz (measured in the simulator)

  // Lower segment and toe in line: they stay parallel to the upper segment.
  constexpr double foot_lever() const { return lower_length + toe_length; }
  constexpr double leg_mass() const { return upper_mass + middle_mass + lower_mass + toe_mass; }
  constexpr double mass() const { return trunk_mass + static_cast<double>(leg_count) * leg_mass(); }
};

inline constexpr body_numbers body{};

static_assert(body.mass() > 5.099 && body.mass() < 5.101);  // published: 5.1 kg

}  // namespace cca::robots::oncilla
