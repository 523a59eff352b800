#pragma once
// The spaces of what flows between the components, besides the robot's own.
//
// Positions are in the frame of the trunk (x forward, y left, z up, from its centre). The position of a foot
// is the centre of its sphere.
#include <algorithm>
#include <cstdint>
#include <limits>

#include <cca/motor/spaces.hpp>
#include <cca/robots/oncilla/spaces.hpp>
#include <cca/space/domain.hpp>

namespace skills {

namespace oncilla = cca::robots::oncilla;  // axes and spaces of the robot

using oncilla::trunk_frame;

struct foot_frame {};

// Of the inputs that have a part in a result, where others rest: what a part said before it was stopped is
// old.
template <class... Ports>
std::int64_t oldest_origin(const Ports&... inputs) {
  std::int64_t oldest = std::numeric_limits<std::int64_t>::max();
  ((oldest = inputs.origin() == cca::never ? oldest : std::min(oldest, inputs.origin())), ...);
  return oldest;
}

struct stride : cca::dimension<"stride"> {};  // one turn of the oscillator: one step of each leg
struct yaw : cca::dimension<"yaw"> {};

// The position of a foot, its target, or the position of the ball.
struct point_in_trunk : cca::space<cca::cartesian_position<trunk_frame>, cca::axes<cca::x, cca::y, cca::z>> {
};

// A hip has two axes, abduction and swing.
struct hip_angles : cca::space<cca::joint_angles,
                               cca::axes<oncilla::left_front_abduction,
                                         oncilla::right_front_abduction,
                                         oncilla::left_hind_abduction,
                                         oncilla::right_hind_abduction,
                                         oncilla::left_front_hip,
                                         oncilla::right_front_hip,
                                         oncilla::left_hind_hip,
                                         oncilla::right_hind_hip>> {};
struct knee_angles : cca::space<cca::joint_angles,
                                cca::axes<oncilla::left_front_knee,
                                          oncilla::right_front_knee,
                                          oncilla::left_hind_knee,
                                          oncilla::right_hind_knee>> {};

// The joints of a leg.
struct left_front_joints
    : cca::space<
          cca::joint_angles,
          cca::axes<oncilla::left_front_abduction, oncilla::left_front_hip, oncilla::left_front_knee>> {};
struct right_front_joints
    : cca::space<
          cca::joint_angles,
          cca::axes<oncilla::right_front_abduction, oncilla::right_front_hip, oncilla::right_front_knee>> {};
struct left_hind_joints
    : cca::space<cca::joint_angles,
                 cca::axes<oncilla::left_hind_abduction, oncilla::left_hind_hip, oncilla::left_hind_knee>> {};
struct right_hind_joints
    : cca::space<
          cca::joint_angles,
          cca::axes<oncilla::right_hind_abduction, oncilla::right_hind_hip, oncilla::right_hind_knee>> {};

struct turning : cca::space<cca::number, cca::axes<yaw>> {};  // > 0 to the left: right legs swing farther
struct wanted_stiffness : cca::space<cca::joint_stiffness, oncilla::hip_axes> {};
struct supports : cca::space<cca::number, oncilla::foot_axes> {
};  // 1: the leg stands and carries, 0: it swings

// The front leg that is nearer to the ball.
enum class paw_side : std::uint8_t { left, right };
struct side_axis : cca::dimension<"side"> {};
struct side_port : cca::space<cca::status, cca::axes<side_axis>> {};

// Is there a ball, and is the robot near enough to stop? Does the paw touch the ground?
enum class ball_state : std::uint8_t { unseen, ahead, near };
enum class paw_state : std::uint8_t { raised, grounded };
struct state_axis : cca::dimension<"state"> {};
struct ball_status : cca::space<cca::status, cca::axes<state_axis>> {};
struct paw_status : cca::space<cca::status, cca::axes<state_axis>> {};
struct trunk_status : cca::space<cca::status, cca::axes<state_axis>> {};  // a criterion_state

}  // namespace skills
