// The body of an Oncilla as a tree of links: the trunk and four pantograph legs in their planes, with the
// numbers of body.hpp. For viewers and for whatever takes a cca::body.
//
//   axes_of<legged_body>   hip and knee of left front, right front, left hind, right hind
//
// The abduction is at 0, and the toe is straight: it is one with the lower segment. Each segment has the
// inertia of a cylinder, the trunk that of a box, as in the simulator.
#pragma once

#include <array>
#include <cstddef>

#include <cca/robot/body.hpp>
#include <cca/robots/oncilla/axes.hpp>
#include <cca/robots/oncilla/kinematics.hpp>
#include <cca/robots/oncilla/spaces.hpp>

namespace cca::robots::oncilla {

namespace detail {

// Along -z, from the origin of its link.
constexpr cca::link_inertia segment(double mass, double length) {
  const double r = body.segment_radius, across = mass * (3 * r * r + length * length) / 12;
  return {mass, {0, 0, -length / 2}, {across, across, mass * r * r / 2}};
}
constexpr cca::link_inertia box(double mass, double x, double y, double z) {
  return {mass, {}, {mass * (y * y + z * z) / 12, mass * (x * x + z * z) / 12, mass * (x * x + y * y) / 12}};
}

inline constexpr cca::link_inertia trunk =
    box(body.trunk_mass, body.trunk_length, body.trunk_width, body.trunk_height);

}  // namespace detail

struct left_front_foot_frame {};
struct right_front_foot_frame {};
struct left_hind_foot_frame {};
struct right_hind_foot_frame {};

template <std::size_t Leg, class Foot, class Hip, class Knee>
struct leg_of_body : cca::pantograph_leg<trunk_frame, Foot, cca::axes<Hip, Knee>, leg_geometry(Leg)> {
  static constexpr std::array links{detail::segment(body.upper_mass, body.upper_length),
                                    detail::segment(body.middle_mass, body.middle_length),
                                    detail::segment(body.lower_mass + body.toe_mass, body.foot_lever())};
};

struct left_front_leg : leg_of_body<0, left_front_foot_frame, left_front_hip, left_front_knee> {};
struct right_front_leg : leg_of_body<1, right_front_foot_frame, right_front_hip, right_front_knee> {};
struct left_hind_leg : leg_of_body<2, left_hind_foot_frame, left_hind_hip, left_hind_knee> {};
struct right_hind_leg : leg_of_body<3, right_hind_foot_frame, right_hind_hip, right_hind_knee> {};

struct legged_body : cca::body<trunk_frame,
                               cca::part<"left_front_leg", left_front_leg>,
                               cca::part<"right_front_leg", right_front_leg>,
                               cca::part<"left_hind_leg", left_hind_leg>,
                               cca::part<"right_hind_leg", right_hind_leg>> {
  static constexpr cca::link_inertia base = detail::trunk;
};

}  // namespace cca::robots::oncilla
