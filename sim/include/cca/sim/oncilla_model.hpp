#pragma once
// Every number of the simulated Oncilla in one table: lengths, masses, springs, motors, contact, engine.
//
// Published for the real robot are the total mass of 5.1 kg, a hip height of about 0.16 to 0.18 m, the kind
// of leg (three segments, pantograph, diagonal spring, knee cable, passive toe, abduction servo) and that a
// trot reaches 0.63 m/s (Sproewitz et al., Frontiers in Robotics and AI 5:67, 2018). No other dimension is
// published in a form that could be used; all others are CHOSEN, so that a leg made of them stands and trots
// like the real one. SI units and radians throughout.
//
// The table is a value: change a copy to simulate another robot. What is fixed at compile time (joint limits
// of the dimensions) is read from `oncilla_defaults`.
#include <array>
#include <cstddef>
#include <numbers>

namespace cca::sim {

inline constexpr std::size_t leg_count = 4;

// Legs in the order of all arrays. Front legs come first, left before right.
enum class leg_id : std::size_t { left_front, right_front, left_hind, right_hind };

constexpr bool is_front(std::size_t leg) { return leg < 2; }
constexpr double side_of(std::size_t leg) {
  return leg % 2 == 0 ? 1.0 : -1.0;
}  // +1: left, the side of positive y
constexpr double degrees(double angle) { return angle * std::numbers::pi / 180.0; }

struct interval {
  double low, high;
  constexpr double clamp(double x) const { return x < low ? low : (x > high ? high : x); }
  constexpr bool holds(double x) const { return low <= x && x <= high; }
};

// A motor's torque over its speed: full torque up to half the no-load speed, then a line down to nothing.
struct motor_line {
  double torque;         // N m
  double no_load_speed;  // rad/s
};

struct oncilla_model {
  // Trunk: a box whose centre of mass lies above the middle of the four hips. It carries the abduction
  // servos.
  double trunk_length = 0.280;
  double trunk_width = 0.110;
  double trunk_height = 0.080;
  double trunk_above_hips = 0.020;
  double trunk_forward_of_hips = 0.0;
  double trunk_mass = 3.66;  // what the legs leave of the 5.1 kg
  double hip_x = 0.1175;     // half the distance of front and hind hips
  double hip_y = 0.075;      // half the distance of left and right hips

  // Leg: upper, middle and lower segment and a toe; upper and lower stay parallel (pantograph).
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

  // Joint ranges. Hip: 0 is straight down, positive swings the foot forward. Knee: flexion, 0 would be the
  // straight leg. Abduction: positive moves the foot outward. Toe: 0 continues the lower segment.
  interval hip_range{-1.2, 1.9};  // forward beyond the horizontal: to reach
  interval knee_range{degrees(35), degrees(150)};
  interval abduction_range{degrees(-20), degrees(20)};
  interval toe_range{-0.8, 0.8};
  double joint_friction = 0.02;  // of the knee, N m s/rad

  // Diagonal spring from the knee to a point of the lower segment, `spring_arm` beyond the ankle.
  double spring_rate = 6254.0;  // N/m
  double spring_arm = 0.035;
  double spring_reference = degrees(60);  // flexion at which the spring's stretch is `spring_preload`
  double spring_preload = -0.0143;        // negative: slack below 83 degrees of flexion

  // Toe spring, a torsion spring with friction in the passive joint.
  double toe_stiffness = 2.0;  // N m/rad
  double toe_damping = 0.003;  // N m s/rad

  // Motors. Hip and abduction servos follow their targets with stiffness and damping; the knee motor winds a
  // cable.
  motor_line hip_motor{6.0, 14.0};
  motor_line knee_motor{6.0, 16.0};
  motor_line abduction_motor{3.0, 6.0};
  double hip_stiffness = 30.0;         // N m/rad while trotting; 120 to stand and reach
  double stiffest_hip = 200.0;         // N m/rad; an explicit torque beyond it chatters
  double hip_damping_time = 0.0125;    // damping = stiffness * this time, s
  double hip_feed_forward_speed = 20;  // rad/s, the fastest motion of the target that the drive believes
  double cable_stiffness = 80.0;       // N m/rad
  double cable_damping = 0.4;          // N m s/rad
  double abduction_stiffness = 80.0;
  double abduction_damping = 0.8;

  // Contact of feet, knees, ankles and trunk with the ground.
  double contact_stiffness = 40e3;  // N/m
  double contact_damping = 200.0;   // N s/m
  double surface_layer = 0.0005;    // depth that is not corrected
  double correcting_speed = 1.0;    // m/s

  // Engine.
  double gravity = 9.81;
  double step = 0.0005;    // s
  int steps_per_beat = 2;  // a beat is 1 ms
  double world_cfm = 1e-9;
  double world_erp = 0.2;
  double pantograph_erp = 0.3;
  double pantograph_cfm = 1e-8;

  // Lower segment and toe in line: what stays parallel to the upper segment.
  constexpr double foot_lever() const { return lower_length + toe_length; }
  constexpr double leg_mass() const { return upper_mass + middle_mass + lower_mass + toe_mass; }
  constexpr double mass() const { return trunk_mass + static_cast<double>(leg_count) * leg_mass(); }
  constexpr double beat() const { return step * steps_per_beat; }
};

inline constexpr oncilla_model oncilla_defaults{};

static_assert(oncilla_defaults.mass() > 5.099 && oncilla_defaults.mass() < 5.101);

}  // namespace cca::sim
