#pragma once
// The spaces of the learned gait, besides those of the robot and of the trot.
#include <cca/cca.hpp>

#include "../trot/spaces.hpp"

namespace walking {

namespace oncilla = cca::robots::oncilla;

struct cosine : cca::dimension<"cosine"> {};
struct sine : cca::dimension<"sine"> {};
struct amplitude : cca::dimension<"amplitude"> {};
struct aside : cca::dimension<"aside"> {};
struct slope : cca::dimension<"slope"> {};
struct forward : cca::dimension<"forward"> {};

// The policy observes and commands at this rate.
using slow = cca::rate<100>;
inline constexpr int period = 10;  // in beats of the robot

// A hand that turns once in a stride, and how far the legs shall swing: 0, stand.
struct stride_clock : cca::space<cca::number, cca::axes<cosine, sine, amplitude>, slow> {};
// The unit vector of gravity.
struct downwards
    : cca::space<cca::cartesian_position<oncilla::trunk_frame>, cca::axes<cca::x, cca::y, cca::z>, slow> {};
// Yaw, rad; its integral, rad s; the mean pitch, rad.
struct course : cca::space<cca::number, cca::axes<trot::yaw, aside, slope>, slow> {};
// m/s, of the trunk towards its nose.
struct trunk_speed : cca::space<cca::number, cca::axes<forward>, oncilla::robot_rate> {};
// rad/s, to the left.
struct turn_rate : cca::space<cca::number, cca::axes<trot::yaw>, oncilla::robot_rate> {};
struct commanded_angles : cca::space<cca::joint_angles, oncilla::leg_axes, slow> {};

}  // namespace walking
