#pragma once
// The spaces of the demonstrator: those of the arm, and what its parts say to each other.
//
// All poses, twists and loads are of the flange, along the axes of the base, unless they say otherwise.
#include <cstdint>

#include <cca/cca.hpp>
#include <cca/motor/dmp_pose.hpp>
#include <cca/robot/compliance/compliance_spaces.hpp>
#include <cca/robots/arm/description.hpp>

namespace touch {

namespace arm = cca::robots::arm;
using base = arm::base_frame;
using flange = arm::flange_frame;

using hand = cca::pose_in<base>;                      // m
using hand_motion = cca::motion_of<flange, base>;     // rad/s, m/s
using load = cca::load_on<flange, base>;              // N m, N: of the world on the flange
using load_in_flange = cca::load_on<flange, flange>;  // the same, as the sensor reads it
using stiffness = cca::stiffness_at<flange, flange>;  // N m/rad, N/m along the axes of the reference
using damping = cca::damping_at<flange, flange>;      // N m s/rad, N s/m along them

// A direction in the base: of unit length.
struct direction : cca::space<cca::number, cca::axes<cca::x, cca::y, cca::z>> {};
// A place in the plane in which the hand wipes, m.
struct cloth : cca::frame<"cloth"> {};
struct place_on_table : cca::space<cca::cartesian_position<cloth>, cca::axes<cca::x, cca::y>> {};
struct stroke : cca::dimension<"stroke"> {};  // one turn of the wiping

struct speed_axis : cca::dimension<"speed"> {};
struct speed : cca::space<cca::number, cca::axes<speed_axis>> {};  // m/s

template <class Axis>
struct status_of_one : cca::space<cca::status, cca::axes<Axis>> {};

enum class recording : std::uint8_t { idle, running, complete };
struct recording_axis : cca::dimension<"recording"> {};
using recording_port = status_of_one<recording_axis>;

enum class way : std::uint8_t { on, arrived };
struct way_axis : cca::dimension<"way"> {};
using way_port = status_of_one<way_axis>;

enum class feeling : std::uint8_t { nothing, table };
struct feeling_axis : cca::dimension<"feeling"> {};
using feeling_port = status_of_one<feeling_axis>;

enum class button : std::uint8_t { released, pressed };
struct button_axis : cca::dimension<"button"> {};
using button_port = status_of_one<button_axis>;

}  // namespace touch
