// The Oncilla described like any other robot: `cca::sim::robot<cca::robots::oncilla::description>`, or
// `cca::hardware::robot<...>` with twelve drives.
//
//   in   "position"   abduction, hip and knee of the left front leg, then of right front, left hind and right
//                     hind, rad. The toes have neither motor nor port
//   out  "angles", "velocities", "torques"                         over the same axes
//        "orientation", "angular_velocity", "acceleration"         of the trunk
//        "left_front_load", "right_front_load", "left_hind_load", "right_hind_load"   on the feet
//
// The numbers are those of body.hpp. CHOSEN, besides: the servos; that abduction and hip have no stops, so
// their ranges bound targets only. They cross in one point, so the link between them needs no mass
// (cca/robots/crossing.hpp).
//
// as_built.hpp is the same robot with the ports by which its controllers know it: cca::sim::oncilla and
// cca::hardware::oncilla. tests/runtime/robot_on_drives/oncilla.cpp has this one on drives.
// docs/robots.md.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include <cca/robots/description.hpp>
#include <cca/robots/oncilla/legged_body.hpp>

namespace cca::robots::oncilla {

template <fixed_string Name>
struct toe : cca::dimension<Name> {
  static constexpr auto limits = cca::limits{cca::angle{body.toe_range.low, body.toe_range.high}};
};
struct left_front_toe : toe<"left_front_toe"> {};
struct right_front_toe : toe<"right_front_toe"> {};
struct left_hind_toe : toe<"left_hind_toe"> {};
struct right_hind_toe : toe<"right_hind_toe"> {};

namespace detail {

constexpr cca::link_inertia ball(double mass, double radius, const std::array<double, 3>& centre) {
  const double i = 0.4 * mass * radius * radius;
  return {mass, centre, {i, i, i}};
}

// The joints of a leg, in the order of its chain.
inline constexpr int knee_joint = 2, ankle_joint = 3;

// From the knee to the end of the lower segment beyond the ankle (law of cosines).
constexpr double diagonal(double knee) {
  const double a = body.middle_length, b = body.spring_arm;
  return cca::detail::constant_root(a * a + b * b - 2 * a * b * cca::detail::constant_cosine(knee));
}
constexpr line_spring diagonal_spring(std::string_view leg) {
  return {.from = point_on(leg, knee_joint, {0, 0, 0}),
          .to = point_on(leg, ankle_joint, {0, 0, body.spring_arm}),
          .stiffness = body.spring_rate,
          .rest = diagonal(body.spring_reference) - body.spring_preload,
          .only_pulls = true};
}

}  // namespace detail

// Abduction and hip cross in one point. The lower segment stays parallel to the upper one.
template <std::size_t Leg, class Foot, class Abduction, class Hip, class Knee, class Toe>
struct walking_leg : cca::serial_chain<trunk_frame, Foot, cca::axes<Abduction, Hip, Knee, Toe>> {
  static constexpr std::array<double, 3> forward{0, -1, 0};  // a segment swings forward about this axis
  static constexpr std::array joints{
      cca::revolute({side_of(Leg), 0, 0}, leg_geometry(Leg).hip), cca::revolute(forward),
      cca::revolute(cca::along_y, cca::at(0, 0, -body.upper_length)),
      cca::revolute(cca::along_y, cca::at(0, 0, -body.middle_length)).driven_by(2, -1),
      cca::revolute(forward, cca::at(0, 0, -body.lower_length)).driven_by(3)};
  static constexpr auto tip = cca::at(0, 0, -body.toe_length);
  static constexpr std::array links{cca::link_inertia{}, detail::segment(body.upper_mass, body.upper_length),
                                    detail::segment(body.middle_mass, body.middle_length),
                                    detail::segment(body.lower_mass, body.lower_length),
                                    detail::ball(body.toe_mass, body.foot_radius, {0, 0, -body.toe_length})};
};

struct left_front_walking_leg : walking_leg<0,
                                            left_front_foot_frame,
                                            left_front_abduction,
                                            left_front_hip,
                                            left_front_knee,
                                            left_front_toe> {};
struct right_front_walking_leg : walking_leg<1,
                                             right_front_foot_frame,
                                             right_front_abduction,
                                             right_front_hip,
                                             right_front_knee,
                                             right_front_toe> {};
struct left_hind_walking_leg : walking_leg<2,
                                           left_hind_foot_frame,
                                           left_hind_abduction,
                                           left_hind_hip,
                                           left_hind_knee,
                                           left_hind_toe> {};
struct right_hind_walking_leg : walking_leg<3,
                                            right_hind_foot_frame,
                                            right_hind_abduction,
                                            right_hind_hip,
                                            right_hind_knee,
                                            right_hind_toe> {};

struct walking_body : cca::body<trunk_frame,
                                cca::part<"left_front_leg", left_front_walking_leg>,
                                cca::part<"right_front_leg", right_front_walking_leg>,
                                cca::part<"left_hind_leg", left_hind_walking_leg>,
                                cca::part<"right_hind_leg", right_hind_walking_leg>> {
  static constexpr cca::link_inertia base = detail::trunk;
};

struct description {
  using body = walking_body;
  using rate = robot_rate;
  using commands = robots::commands<position_command>;
  using sensors = robots::sensors<orientation_sensor<"orientation", world_frame>,
                                  gyroscope<"angular_velocity">,
                                  accelerometer<"acceleration">,
                                  force_sensor<"left_front_load", "left_front_leg">,
                                  force_sensor<"right_front_load", "right_front_leg">,
                                  force_sensor<"left_hind_load", "left_hind_leg">,
                                  force_sensor<"right_hind_load", "right_hind_leg">>;
  static constexpr bool floats = true;

  static constexpr const body_numbers& of = oncilla::body;
  static constexpr joint_drive abduction{
      .motor = of.abduction_motor, .stiffness = 80, .damping = 0.8, .stops = false};
  static constexpr joint_drive hip{.motor = of.hip_motor, .stiffness = 30, .damping = 0.375, .stops = false};
  static constexpr joint_drive knee{
      .motor = of.knee_motor, .friction = of.joint_friction, .cable = {.stiffness = 80, .damping = 0.4}};
  static constexpr joint_drive toe{.friction = of.toe_damping, .spring = of.toe_stiffness, .measured = false};
  static constexpr std::array<joint_drive, 16> drives{abduction, hip, knee, toe, abduction, hip, knee, toe,
                                                      abduction, hip, knee, toe, abduction, hip, knee, toe};

  static constexpr std::array line_springs{
      detail::diagonal_spring("left_front_leg"), detail::diagonal_spring("right_front_leg"),
      detail::diagonal_spring("left_hind_leg"), detail::diagonal_spring("right_hind_leg")};

  // Feet, knees, ankles and the trunk.
  static constexpr auto shapes = [] {
    std::array<shape_on, 13> all{on_base(box(of.trunk_length, of.trunk_width, of.trunk_height))};
    std::size_t next = 1;
    for (const std::string_view leg :
         {"left_front_leg", "right_front_leg", "left_hind_leg", "right_hind_leg"}) {
      all[next++] = at_tip(leg, sphere(of.foot_radius));
      all[next++] = on_link(leg, detail::knee_joint, sphere(of.knee_radius));
      all[next++] = on_link(leg, detail::ankle_joint, sphere(of.ankle_radius));
    }
    return all;
  }();

  // Feet a little ahead of the hips.
  static constexpr double bent = 1.4, ahead = 0.75;
  static constexpr std::array<double, 16> start{0, ahead, bent, 0, 0, ahead, bent, 0,
                                                0, ahead, bent, 0, 0, ahead, bent, 0};
};

}  // namespace cca::robots::oncilla
